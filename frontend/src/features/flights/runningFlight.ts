import type { Connection } from "../../store/connection";

/** The flight that is being recorded. */
export interface RunningFlight {
  readonly id: string;
  readonly bytes: number;
  readonly started_s: number;
  readonly duration_s: number;
}

const ID = /(\d{4})(\d{2})(\d{2})T(\d{2})(\d{2})(\d{2})Z(-\d{1,4})?(?=\.mcap$)/;

/** What the status says of the recording; null while nothing is recorded, or while the gateway is silent. */
export function runningFlight({ phase, status }: Connection): RunningFlight | null {
  const recording = status?.recording;
  const found = phase === "open" && recording?.active === true ? ID.exec(recording.file ?? "") : null;
  if (found === null || status === null || recording === undefined) {
    return null;
  }
  const [year, month, day, hour, minute, second] = found.slice(1, 7).map(Number) as [
    number,
    number,
    number,
    number,
    number,
    number,
  ];
  const started_s = Date.UTC(year, month - 1, day, hour, minute, second) / 1000;
  return {
    id: found[0],
    bytes: recording.bytes,
    started_s,
    duration_s: Math.max(0, status.server_time_s - started_s),
  };
}
