import { formatFlightTime } from "../../lib/moment";

/** A stretch of a flight, seconds since its start. */
export interface Stretch {
  readonly from_s: number;
  readonly to_s: number;
}

/** What the plots show: all of the flight, its last seconds, or a stretch that somebody chose. */
export type View =
  | { readonly kind: "all" }
  | { readonly kind: "last"; readonly span_s: number }
  | { readonly kind: "stretch"; readonly from_s: number; readonly to_s: number };

export const ALL: View = { kind: "all" };
/** What is shown of a flight under way before anybody chose. */
export const LAST: View = { kind: "last", span_s: 60 };

/** The closest zoom: single samples of the fastest stream are far apart. */
const LEAST_SPAN_S = 0.2;
/** A flight that has just begun is drawn as if it were so long. */
const FIRST_SPAN_S = 5;

/** The seconds that are shown of a flight that reaches to `edge_s`. */
export function stretchOf(view: View, edge_s: number): Stretch {
  switch (view.kind) {
    case "all":
      return { from_s: 0, to_s: Math.max(FIRST_SPAN_S, edge_s) };
    case "last":
      return { from_s: Math.max(0, edge_s - view.span_s), to_s: Math.max(view.span_s, edge_s) };
    default:
      return { from_s: view.from_s, to_s: view.to_s };
  }
}

/** Closer (`factor` under 1) or further away; the moment `about_s` stays where it is. */
export function zoomed({ from_s, to_s }: Stretch, about_s: number, factor: number, edge_s: number): View {
  const span_s = Math.max(LEAST_SPAN_S, (to_s - from_s) * factor);
  const whole = stretchOf(ALL, edge_s);
  if (span_s >= whole.to_s) {
    return ALL;
  }
  const share = (about_s - from_s) / (to_s - from_s);
  return within(about_s - share * span_s, span_s, whole.to_s);
}

export function panned({ from_s, to_s }: Stretch, by_s: number, edge_s: number): View {
  return within(from_s + by_s, to_s - from_s, stretchOf(ALL, edge_s).to_s);
}

/** The stretch between two moments, in whatever order. */
export function between(one_s: number, other_s: number, edge_s: number): View {
  const span_s = Math.max(LEAST_SPAN_S, Math.abs(other_s - one_s));
  return within(Math.min(one_s, other_s), span_s, stretchOf(ALL, edge_s).to_s);
}

function within(from_s: number, span_s: number, end_s: number): View {
  const first_s = Math.min(Math.max(0, from_s), Math.max(0, end_s - span_s));
  return { kind: "stretch", from_s: first_s, to_s: first_s + span_s };
}

/** Time of a flight, as fine as the stretch that is shown needs: "1:02:03", "2:03", "2:03.45". */
export function formatAt(at_s: number, span_s: number): string {
  return formatFlightTime(at_s, span_s < 2 ? 2 : span_s < 20 ? 1 : 0);
}
