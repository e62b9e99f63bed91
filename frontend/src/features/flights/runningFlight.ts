import { readFlightName } from "../../lib/flightName";
import type { Connection } from "../../store/connection";

/** The flight that is being recorded. */
export interface RunningFlight {
  readonly id: string;
  readonly bytes: number;
  readonly started_s: number;
  readonly duration_s: number;
}

/** What the status says of the recording; null while nothing is recorded, or while the gateway is silent. */
export function runningFlight({ phase, status }: Connection): RunningFlight | null {
  const recording = status?.recording;
  const found = phase === "open" && recording?.active === true ? readFlightName(recording.file ?? "") : null;
  if (found === null || status === null || recording === undefined) {
    return null;
  }
  return {
    ...found,
    bytes: recording.bytes,
    duration_s: Math.max(0, status.server_time_s - found.started_s),
  };
}
