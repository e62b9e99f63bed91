import { AIRCRAFT, type Aircraft } from "../lib/aircraft";
import { useSettings, useTelemetry } from "../store/hooks";

/** The setting that stores which aircraft is looked at. */
export const FOLLOWED_CHOICE = "map.followed";

/**
 * The aircraft that is looked at: the chosen one; by default the simulator's as soon as it is heard. One that falls
 * silent is crossed out and not replaced by the other, which would look like it.
 */
export function useFlownAircraft(): Aircraft {
  const chosen = useSettings(({ choices }) => AIRCRAFT.find((one) => one === choices[FOLLOWED_CHOICE]));
  const isSimulated = useTelemetry((telemetry, now_ms) => telemetry.state("simulator", now_ms) !== "none");
  return chosen ?? (isSimulated ? "hil" : "flight");
}
