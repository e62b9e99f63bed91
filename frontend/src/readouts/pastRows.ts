import type { HistoryRow } from "../lib/signalHistory";
import type { Signals } from "../protocol/guards.gen";
import { operandsOf, type Signal, signalKey, signalValue } from "./signals";

interface RowTimes {
  /** Shortest time between rows. */
  readonly step_s: number;
  /** A sample that is older than this is none. */
  readonly lapse_s: number;
}

/** Recorded samples as rows of the signals that are made of them, Unix seconds. Each value is that of the last sample. */
export function pastRows(
  { starts_s, signals: recorded }: Signals,
  signals: readonly Signal[],
  { step_s, lapse_s }: RowTimes,
): HistoryRow[] {
  const operands = new Set(signals.flatMap(operandsOf));
  const known = recorded.filter(({ name }) => operands.has(name));
  const places = new Map(known.map(({ name }) => [name, -1]));
  return timesOf(known, step_s).map((at_s): HistoryRow => {
    const newest = new Map<string, number | null>();
    for (const { name, at_s: times, max } of known) {
      let place = places.get(name) ?? -1;
      while ((times[place + 1] ?? Number.POSITIVE_INFINITY) <= at_s) {
        place += 1;
      }
      places.set(name, place);
      const isRecent = at_s - (times[place] ?? Number.NEGATIVE_INFINITY) <= lapse_s;
      newest.set(name, isRecent ? (max[place] ?? null) : null);
    }
    const row = new Map(
      signals.map((signal) => [
        signalKey(signal),
        signalValue(
          signal,
          operandsOf(signal).map((name) => newest.get(name) ?? null),
        ),
      ]),
    );
    return { time_s: starts_s + at_s, read: (key) => row.get(key) ?? null };
  });
}

/** The moments of all samples in their order, those that are too near to the one before left out. */
function timesOf(recorded: Signals["signals"], step_s: number): number[] {
  const all = recorded.flatMap(({ at_s }) => at_s).sort((one, other) => one - other);
  let last_s = Number.NEGATIVE_INFINITY;
  return all.filter((at_s) => {
    const isNext = at_s - last_s >= step_s;
    last_s = isNext ? at_s : last_s;
    return isNext;
  });
}
