import type { NumberField, TopicName } from "../protocol/topics";
import type { TelemetryStore } from "../store/telemetry";

interface Shown {
  /** What the reader calls it. */
  readonly label: string;
  /** Unit of what is drawn; signals of one unit share an axis. */
  readonly unit?: string;
  /** From the topic's unit into the drawn one; a function of the module. */
  readonly scale?: (value: number) => number;
}

/** A number of a topic that is drawn over time. */
export type TopicSignal = {
  [T in TopicName]: { readonly topic: T; readonly field: NumberField<T> };
}[TopicName] &
  Shown;

/** One of the eight values of a row of X-Plane, whatever the row means. */
export interface RowSignal extends Shown {
  readonly row: number;
  readonly index: number;
}

export type Signal = TopicSignal | RowSignal;

/** Two signals of one key are one: the same value, drawn in the same unit. */
export function signalKey(signal: Signal): string {
  const source = "row" in signal ? `row.${signal.row}.${signal.index}` : `${signal.topic}.${signal.field}`;
  return `${source} ${signal.unit ?? ""}`;
}

/** The signal's value in the unit in which it is drawn; null while it is not live. */
export function liveSignal(telemetry: TelemetryStore, signal: Signal, now_ms: number): number | null {
  const value =
    "row" in signal
      ? telemetry.liveRowValue(signal.row, signal.index, now_ms)
      : telemetry.liveNumberOf(signal.topic, signal.field, now_ms);
  return value === null || signal.scale === undefined ? value : signal.scale(value);
}
