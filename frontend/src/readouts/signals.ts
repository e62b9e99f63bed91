import type { NumberField, TopicName } from "../protocol/topics";
import type { TelemetryStore } from "../store/telemetry";

interface SignalText {
  /** Its name for the user. */
  readonly label: string;
  /** Unit in the plot; signals of one unit share an axis. */
  readonly unit?: string;
  /** Conversion from the topic's unit to the plot's; defined at module level. */
  readonly scale?: (value: number) => number;
  /** Its axis spans at least this, in the plot's unit, so that noise does not fill the picture. */
  readonly least_span?: number;
  /** An angle that goes on at zero after this; the line is broken there. */
  readonly turn?: number;
}

/** A number of a topic to be plotted. */
export type TopicSignal = {
  [T in TopicName]: { readonly topic: T; readonly field: NumberField<T> };
}[TopicName] &
  SignalText;

/** One of the eight values of a row of X-Plane, whatever the row means. */
export interface RowSignal extends SignalText {
  readonly row: number;
  readonly index: number;
}

export type Signal = TopicSignal | RowSignal;

/** Signals with the same key are the same: same value, same unit. */
export function signalKey(signal: Signal): string {
  const source = "row" in signal ? `row.${signal.row}.${signal.index}` : `${signal.topic}.${signal.field}`;
  return `${source} ${signal.unit ?? ""}`;
}

/** The signal's value in the plot's unit; null if not live. */
export function liveSignal(telemetry: TelemetryStore, signal: Signal, now_ms: number): number | null {
  const value =
    "row" in signal
      ? telemetry.liveRowValue(signal.row, signal.index, now_ms)
      : telemetry.liveNumberOf(signal.topic, signal.field, now_ms);
  return value === null || signal.scale === undefined ? value : signal.scale(value);
}
