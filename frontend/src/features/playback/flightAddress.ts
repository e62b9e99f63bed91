import type { Timers } from "../../lib/timers";

/** A moment of a flight. */
export interface PlaceInTime {
  readonly flight: string;
  readonly at_s: number;
}

/** The browser's address line, or a test's. */
export interface AddressLine {
  readonly read: () => string;
  /** Replace the address without loading the page. */
  readonly replace: (address: string) => void;
}

/** Keeps the page's address at the moment that is shown, so that it can be shared. */
export interface FlightAddress {
  /** The moment that the page was opened with; null for the present. */
  readonly opened: () => PlaceInTime | null;
  /** The address follows a moving moment once a second: browsers limit how often it may change. */
  readonly keep: (place: PlaceInTime | null) => void;
  readonly of: (place: PlaceInTime | null) => string;
}

const FLIGHT = /^(current|[0-9]{8}T[0-9]{6}Z(-[0-9]{1,4})?)$/;
const EVERY_MS = 1000;

export function createFlightAddress(line: AddressLine, timers: Timers): FlightAddress {
  let wanted: PlaceInTime | null = null;
  let isWaiting = false;
  let written_ms = Number.NEGATIVE_INFINITY;

  function of(place: PlaceInTime | null): string {
    const address = new URL(line.read());
    address.searchParams.delete("flight");
    address.searchParams.delete("at");
    if (place !== null) {
      address.searchParams.set("flight", place.flight);
      address.searchParams.set("at", place.at_s.toFixed(2));
    }
    return address.toString();
  }

  function write(): void {
    isWaiting = false;
    written_ms = timers.now_ms();
    const address = of(wanted);
    if (address !== line.read()) {
      line.replace(address);
    }
  }

  return {
    opened: () => {
      const { searchParams } = new URL(line.read());
      const flight = searchParams.get("flight");
      const at_s = Number(searchParams.get("at") ?? "0");
      return flight !== null && FLIGHT.test(flight)
        ? { flight, at_s: Number.isFinite(at_s) ? Math.max(0, at_s) : 0 }
        : null;
    },
    keep: (place) => {
      wanted = place;
      if (place === null || timers.now_ms() - written_ms >= EVERY_MS) {
        write();
      } else if (!isWaiting) {
        isWaiting = true;
        timers.after(EVERY_MS, () => isWaiting && write());
      }
    },
    of,
  };
}
