import { createStore, type StoreApi } from "zustand/vanilla";
import type { Problem } from "../../protocol/answers";
import { type FlightReport, isFlightReport } from "../../protocol/guards.gen";
import type { Gateway } from "../../requests/asking";
import { partName } from "../../store/parts";

/** The report that is open. `compare` is the earlier flight beside it; while it is made, `report` is the one before. */
export interface OpenReport {
  readonly flight: string;
  readonly compare: string | null;
  readonly report: FlightReport | null;
  readonly problem: Problem | null;
  readonly isWorking: boolean;
}

export interface Reports {
  /** Null while none is open. */
  readonly store: StoreApi<OpenReport | null>;
  readonly open: (flight: string, compare?: string | null) => void;
  readonly close: () => void;
}

export const REPORTS = partName<Reports>("reports");

/** Two hours at the full line take seconds; a slow computer may need more. */
const PATIENCE_MS = 120_000;
const ID = /^[0-9]{8}T[0-9]{6}Z(-[0-9]{1,4})?$/;

export function reportPath(flight: string, compare: string | null, page?: "es" | "en"): string {
  const query = new URLSearchParams();
  if (compare !== null) {
    query.set("compare", compare);
  }
  if (page !== undefined) {
    query.set("format", "html");
    query.set("lang", page);
  }
  const text = query.toString();
  return `/api/v1/flights/${flight}/report${text === "" ? "" : `?${text}`}`;
}

/** The report that an address names: ?report=ID&compare=ID. */
export function addressedReport(address: string): { flight: string; compare: string | null } | null {
  const { searchParams } = new URL(address);
  const [flight, compare] = [searchParams.get("report"), searchParams.get("compare")];
  if (flight === null || !ID.test(flight)) {
    return null;
  }
  return { flight, compare: compare !== null && ID.test(compare) ? compare : null };
}

/** `opened` is told of each change, so that the page's address can hold it. */
export function createReports(
  rest: Gateway,
  opened: (flight: string | null, compare: string | null) => void,
): Reports {
  const store = createStore<OpenReport | null>(() => null);

  async function ask(flight: string, compare: string | null): Promise<void> {
    const answer = await rest.ask("GET", reportPath(flight, compare), isFlightReport, undefined, PATIENCE_MS);
    const now = store.getState();
    // Another one was opened meanwhile, or none.
    if (now === null || now.flight !== flight || now.compare !== compare) {
      return;
    }
    const ended = answer.ok ? { report: answer.value, problem: null } : { problem: answer.problem };
    store.setState({ ...now, ...ended, isWorking: false }, true);
  }

  return {
    store,
    open: (flight, compare = null) => {
      const now = store.getState();
      const report = now?.flight === flight ? now.report : null;
      store.setState({ flight, compare, report, problem: null, isWorking: true }, true);
      opened(flight, compare);
      void ask(flight, compare);
    },
    close: () => {
      store.setState(null, true);
      opened(null, null);
    },
  };
}

/** The browser's address line, or a test's. */
interface Line {
  readonly read: () => string;
  readonly replace: (address: string) => void;
}

/** The page's address names the report that is open, so that it can be shared. */
export function keepReport(line: Line, flight: string | null, compare: string | null): void {
  const address = new URL(line.read());
  for (const [key, value] of [
    ["report", flight],
    ["compare", compare],
  ] as const) {
    if (value === null) {
      address.searchParams.delete(key);
    } else {
      address.searchParams.set(key, value);
    }
  }
  line.replace(address.toString());
}
