/** The part of a flight that the bar shows, seconds since its start. */
export interface BarView {
  readonly from_s: number;
  readonly to_s: number;
}

/** The bar shows at least so much: at the closest, single frames can be told apart. */
export const LEAST_SPAN_S = 2;
/** A bar whose flight has just begun shows this much, so that its first seconds do not fill it. */
const FIRST_SPAN_S = 30;

export function wholeFlight(edge_s: number): BarView {
  return { from_s: 0, to_s: Math.max(FIRST_SPAN_S, edge_s) };
}

/** Pixels from the bar's left edge. */
export function xOf(at_s: number, { from_s, to_s }: BarView, width: number): number {
  return ((at_s - from_s) / (to_s - from_s)) * width;
}

/** The moment at a pixel. */
export function atOf(x: number, { from_s, to_s }: BarView, width: number): number {
  return width <= 0 ? from_s : from_s + (x / width) * (to_s - from_s);
}

/** The view after zooming by `factor` (under 1: closer); the moment `about_s` stays where it is. */
export function zoomed(view: BarView, about_s: number, factor: number, edge_s: number): BarView {
  const whole = wholeFlight(edge_s);
  const span_s = view.to_s - view.from_s;
  const next_s = Math.min(whole.to_s, Math.max(LEAST_SPAN_S, span_s * factor));
  const share = (about_s - view.from_s) / span_s;
  return within({ from_s: about_s - share * next_s, to_s: about_s + (1 - share) * next_s }, edge_s);
}

export function panned(view: BarView, by_s: number, edge_s: number): BarView {
  return within({ from_s: view.from_s + by_s, to_s: view.to_s + by_s }, edge_s);
}

/** The view moved as little as needed to have this moment in it, with a tenth of it to spare. */
export function showing(view: BarView, at_s: number, edge_s: number): BarView {
  const spare_s = (view.to_s - view.from_s) / 10;
  if (at_s < view.from_s) {
    return panned(view, at_s - spare_s - view.from_s, edge_s);
  }
  return at_s > view.to_s ? panned(view, at_s + spare_s - view.to_s, edge_s) : view;
}

/** Moved, and where it is too long cut, so that it lies in the flight. */
function within({ from_s, to_s }: BarView, edge_s: number): BarView {
  const whole = wholeFlight(edge_s);
  const span_s = Math.min(to_s - from_s, whole.to_s);
  const first_s = Math.min(Math.max(0, from_s), whole.to_s - span_s);
  return { from_s: first_s, to_s: first_s + span_s };
}

const STEPS_S = [0.1, 0.2, 0.5, 1, 2, 5, 10, 15, 30, 60, 120, 300, 600, 900, 1800, 3600, 7200, 14_400];

/** Round moments of the view, at least `least_px` apart. */
export function ticks(view: BarView, width: number, least_px: number): readonly number[] {
  const span_s = view.to_s - view.from_s;
  const step_s = STEPS_S.find((step) => (step / span_s) * width >= least_px) ?? 14_400;
  const first = Math.ceil(view.from_s / step_s);
  const last = Math.floor(view.to_s / step_s);
  return Array.from({ length: Math.max(0, last - first + 1) }, (_, index) => (first + index) * step_s);
}
