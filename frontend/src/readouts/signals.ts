import type { NumberField, TopicName } from "../protocol/topics";
import type { TelemetryStore } from "../store/telemetry";

export interface SignalText {
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

/** What a law of the board makes of values of topics, in the plot's unit. */
export interface LawSignal extends SignalText {
  readonly law: string;
  /** `topic.field`; a flag is 0 or 1. */
  readonly operands: readonly string[];
  /** Of the operands in their order, null where one is not known; null: it asks for nothing. */
  readonly compute: (operands: ReadonlyArray<number | null>) => number | null;
}

export type Signal = TopicSignal | RowSignal | LawSignal;

/** Signals with the same key are the same: same value, same unit. */
export function signalKey(signal: Signal): string {
  return `${sourceOf(signal)} ${signal.unit ?? ""}`;
}

function sourceOf(signal: Signal): string {
  if ("row" in signal) {
    return `row.${signal.row}.${signal.index}`;
  }
  return "law" in signal ? `law.${signal.law}` : `${signal.topic}.${signal.field}`;
}

/** The recorded values, `topic.field`, that a signal is made of. */
export function operandsOf(signal: Signal): readonly string[] {
  if ("row" in signal) {
    return [];
  }
  return "law" in signal ? signal.operands : [`${signal.topic}.${signal.field}`];
}

/** The signal's value in the plot's unit, of those of its operands in their order; null if it has none. */
export function signalValue(signal: Signal, operands: ReadonlyArray<number | null>): number | null {
  const value = "law" in signal ? signal.compute(operands) : (operands[0] ?? null);
  return value === null || signal.scale === undefined ? value : signal.scale(value);
}

/** The signal's value in the plot's unit; null if not live. */
export function liveSignal(telemetry: TelemetryStore, signal: Signal, now_ms: number): number | null {
  return signalValue(
    signal,
    "row" in signal
      ? [telemetry.liveRowValue(signal.row, signal.index, now_ms)]
      : operandsOf(signal).map((name) => liveOperand(telemetry, name, now_ms)),
  );
}

function liveOperand(telemetry: TelemetryStore, name: string, now_ms: number): number | null {
  const [topic = "", field = ""] = name.split(".");
  if (telemetry.state(topic, now_ms) !== "live") {
    return null;
  }
  const value = telemetry.newestValueOf(topic, field);
  return typeof value === "boolean" ? Number(value) : value;
}
