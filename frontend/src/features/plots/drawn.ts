import type { Signal } from "../../protocol/guards.gen";
import { shownUnit } from "./signalNames";

type Values = ReadonlyArray<number | null>;

/**
 * A signal as it is drawn: steps in order of time with the least and the greatest value in each; null is a gap. Times
 * are seconds since the flight's start. `mean` and `count` are of all samples of the stretch.
 */
export interface PlotSeries {
  readonly name: string;
  readonly unit: string;
  /** From the unit of the wire to this one. */
  readonly factor: number;
  readonly at_s: readonly number[];
  readonly low: Values;
  readonly high: Values;
  readonly least: number | null;
  readonly greatest: number | null;
  readonly mean: number | null;
  readonly count: number;
  /** Further from a step than this, there is no value. */
  readonly reach_s: number;
}

const LEAST_REACH_S = 0.5;
const REACH_STEPS = 6;

/** The gateway's answer as it is drawn; `shift_s` is taken from its times. */
export function drawnOf(signal: Signal, shift_s = 0): PlotSeries {
  const { unit, factor } = shownUnit(signal.unit);
  const at_s: number[] = [];
  const low: Array<number | null> = [];
  const high: Array<number | null> = [];
  for (const [index, time_s] of signal.at_s.entries()) {
    const least = scaled(signal.min[index], factor);
    const greatest = scaled(signal.max[index], factor);
    if (at_s.length > 0 && at_s.at(-1) === time_s - shift_s) {
      // Two samples of one moment are one step, so that neither hides the other.
      const last = at_s.length - 1;
      low[last] = extreme(Math.min, low[last], least);
      high[last] = extreme(Math.max, high[last], greatest);
    } else {
      at_s.push(time_s - shift_s);
      low.push(least);
      high.push(greatest);
    }
  }
  return {
    name: signal.name,
    unit,
    factor,
    at_s,
    low,
    high,
    least: over(low, Math.min),
    greatest: over(high, Math.max),
    mean: signal.mean === null ? null : signal.mean * factor,
    count: signal.count,
    reach_s: reachOf(at_s),
  };
}

function scaled(value: number | null | undefined, factor: number): number | null {
  return value === null || value === undefined ? null : value * factor;
}

type Pick = (one: number, other: number) => number;

function extreme(pick: Pick, one: number | null | undefined, other: number | null): number | null {
  if (one === null || one === undefined) {
    return other;
  }
  return other === null ? one : pick(one, other);
}

function over(values: Values, pick: Pick): number | null {
  return values.reduce<number | null>((found, value) => extreme(pick, found, value), null);
}

/** A few usual steps; without a usual step a value holds on. */
export function reachOf(at_s: readonly number[]): number {
  if (at_s.length < 3) {
    return Number.POSITIVE_INFINITY;
  }
  const steps = at_s.slice(1).map((time_s, index) => time_s - (at_s[index] ?? time_s));
  steps.sort((one, other) => one - other);
  return Math.max(LEAST_REACH_S, REACH_STEPS * (steps[steps.length >> 1] ?? 0));
}

/** Index of the last step at or before a moment; -1 before the first. */
export function lastBefore(at_s: readonly number[], moment_s: number): number {
  let low = 0;
  let high = at_s.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if ((at_s[middle] ?? 0) <= moment_s) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low - 1;
}

/** The extremes of the step nearest to a moment; null in a gap, and far from any step. */
export function valueAt(drawn: PlotSeries, moment_s: number): readonly [number, number] | null {
  const before = lastBefore(drawn.at_s, moment_s);
  const isAfter =
    before < 0 ||
    (drawn.at_s[before + 1] ?? Number.POSITIVE_INFINITY) - moment_s < moment_s - (drawn.at_s[before] ?? 0);
  const index = isAfter ? before + 1 : before;
  const [time_s, low, high] = [drawn.at_s[index], drawn.low[index] ?? null, drawn.high[index] ?? null];
  return time_s === undefined || low === null || high === null || Math.abs(time_s - moment_s) > drawn.reach_s
    ? null
    : [low, high];
}

/** The steps of a stretch, with one more on each side so that lines reach the edges. */
export function cut(drawn: PlotSeries, from_s: number, to_s: number): PlotSeries {
  const first = Math.max(0, lastBefore(drawn.at_s, from_s));
  const end = lastBefore(drawn.at_s, to_s) + 2;
  return {
    ...drawn,
    at_s: drawn.at_s.slice(first, end),
    low: drawn.low.slice(first, end),
    high: drawn.high.slice(first, end),
  };
}
