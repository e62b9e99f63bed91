/** How the list may be sorted. */
export const SORTS = [
  "started",
  "duration",
  "distance",
  "highest",
  "fastest",
  "alarms",
  "marks",
  "title",
  "bytes",
] as const;
export type Sort = (typeof SORTS)[number];

/** Which flights are asked for. `from` and `to` are local days ("2026-01-31") or empty. */
export interface FlightQuery {
  readonly text: string;
  readonly tag: string | null;
  readonly board: string | null;
  readonly aircraft: string | null;
  readonly operator: string | null;
  readonly from: string;
  readonly to: string;
  readonly sort: Sort;
  readonly order: "asc" | "desc";
  /** From 1. */
  readonly page: number;
}

export const ALL_FLIGHTS: FlightQuery = {
  text: "",
  tag: null,
  board: null,
  aircraft: null,
  operator: null,
  from: "",
  to: "",
  sort: "started",
  order: "desc",
  page: 1,
};

/** What the list is narrowed by that the library names itself. */
const NAMES = ["tag", "board", "aircraft", "operator"] as const;

export const PER_PAGE = 50;

/** Whether anything narrows the list. */
export function isFiltered(query: FlightQuery): boolean {
  const { text, from, to } = query;
  return text.trim() !== "" || from !== "" || to !== "" || NAMES.some((name) => query[name] !== null);
}

/** The address of one page of the flights that are asked for. */
export function flightsPath(query: FlightQuery): string {
  const { text, from, to, sort, order, page } = query;
  const [from_s, to_s] = [dayStarts_s(from, 0), dayStarts_s(to, 1)];
  const words = new URLSearchParams({
    ...(text.trim() === "" ? {} : { text: text.trim() }),
    ...Object.fromEntries(NAMES.flatMap((name) => (query[name] === null ? [] : [[name, query[name]]]))),
    ...(from_s === null ? {} : { from_s: String(from_s) }),
    ...(to_s === null ? {} : { to_s: String(to_s) }),
    sort,
    order,
    page: String(page),
    per_page: String(PER_PAGE),
  });
  return `/api/v1/flights?${words}`;
}

/** When a local day starts, so many days later, in Unix seconds; null if the text is no day. */
function dayStarts_s(day: string, days_later: number): number | null {
  const found = /^(\d{4})-(\d{2})-(\d{2})$/.exec(day);
  if (found === null) {
    return null;
  }
  // By the calendar and not by 24 hours: a day on which the clock changes is longer or shorter.
  const [year, month, date] = found.slice(1).map(Number) as [number, number, number];
  const starts_ms = new Date(year, month - 1, date + days_later).getTime();
  return Number.isFinite(starts_ms) ? Math.max(0, starts_ms / 1000) : null;
}
