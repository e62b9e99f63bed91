import { useTelemetry } from "../../store/hooks";

/** Whole seconds until a moment of the station's clock, never below 0; 0 while one of the two is not known. */
export function useSecondsTo(moment_s: number | null): number {
  return useTelemetry((telemetry, now_ms) => {
    const clock_s = telemetry.clock_s(now_ms);
    return moment_s === null || clock_s === null ? 0 : Math.max(0, Math.ceil(moment_s - clock_s));
  });
}
