const NAME = /(\d{4})(\d{2})(\d{2})T(\d{2})(\d{2})(\d{2})Z(-\d{1,4})?(?=\.mcap$|$)/;

/** A flight is named by the second in which its recording began. */
export interface FlightName {
  readonly id: string;
  /** Unix seconds. */
  readonly started_s: number;
}

/** Read a flight's name, or that of its file; null if it is neither. */
export function readFlightName(text: string): FlightName | null {
  const found = NAME.exec(text);
  if (found === null) {
    return null;
  }
  const [year = 0, month = 1, day = 1, hour = 0, minute = 0, second = 0] = found.slice(1, 7).map(Number);
  return { id: found[0], started_s: Date.UTC(year, month - 1, day, hour, minute, second) / 1000 };
}
