import { FIELDS, XPLANE_ROWS, type XplaneProfile } from "../../protocol/messages.gen";
import { FIELD_KINDS } from "../../protocol/topics";
import type { Signal, TopicSignal } from "../../readouts/signals";
import { PLOT_COLOURS } from "../../ui/plotColours";
import { unitSymbol } from "./unitSymbols";

/** As many lines as can be told apart. */
export const MOST_PLOTTED = PLOT_COLOURS;

/** The stored key of a signal: "ahrs.roll_deg", "row.17.0". */
export type PlotKeyText = string;

const NONE: ReadonlyMap<PlotKeyText, string> = new Map();
const OWN = /^own\.([a-z][a-z0-9_]*)\.([a-z][a-z0-9_]*)$/;

export function rowKey(row: number, index: number): PlotKeyText {
  return `row.${row}.${index}`;
}

/** The key of a field of a board message, or null if it is no number of the page's stream. */
export function fieldKey(topic: string, field: string): PlotKeyText | null {
  const isNumber =
    FIELD_KINDS.get(topic)?.some(([name, kind]) => name === field && kind === "number") === true;
  return isNumber ? `${topic}.${field}` : null;
}

/** The key of a number of a topic that the board describes itself: its unit is known by the board alone. */
export function ownKey(topic: string, field: string): PlotKeyText {
  return `own.${topic}.${field}`;
}

/** The meaning of one of a row's eight values, by the simulator's profile; null if the definition has none. */
export function rowValue(
  profile: XplaneProfile,
  row: number,
  index: number,
): { readonly name: string; readonly unit: string } | null {
  const value = XPLANE_ROWS[profile]
    .find(({ id }) => id === row)
    ?.values.find((candidate) => candidate.index === index);
  return value === undefined ? null : { name: value.name, unit: unitSymbol(value.unit) };
}

/** The unit symbol of a board message's field; empty if it has none or it is unknown. */
function fieldUnit(topic: string, field: string): string {
  const fields: Readonly<Record<string, Readonly<Record<string, { readonly unit: string }>>>> = FIELDS;
  return unitSymbol(fields[topic]?.[field]?.unit ?? "");
}

/**
 * The signal of a key, or null if there is no such signal (any more). `ownUnits`: the unit symbols of the topics that
 * the board describes itself, by key.
 */
export function signalOf(
  key: PlotKeyText,
  profile: XplaneProfile,
  ownUnits: ReadonlyMap<PlotKeyText, string> = NONE,
): Signal | null {
  const own = OWN.exec(key);
  if (own !== null) {
    const [, topic = "", field = ""] = own;
    return {
      topic,
      field,
      label: `${topic}.${field}`,
      unit: ownUnits.get(key) ?? "",
    } as unknown as TopicSignal;
  }
  const row = /^row\.(\d{1,4})\.([0-7])$/.exec(key);
  if (row !== null) {
    const [number, index] = [Number(row[1]), Number(row[2])];
    const known = rowValue(profile, number, index);
    return { row: number, index, label: `${number}: ${known?.name ?? index}`, unit: known?.unit ?? "" };
  }
  const [topic = "", field = ""] = key.split(".");
  return fieldKey(topic, field) === null
    ? null
    : ({ topic, field, label: key, unit: fieldUnit(topic, field) } as unknown as TopicSignal);
}

/** The stored keys that are still valid, without duplicates, at most `MOST_PLOTTED`. */
export function parsePlotted(text: string | undefined, profile: XplaneProfile): readonly PlotKeyText[] {
  const keys = new Set((text ?? "").split(" ").filter((key) => signalOf(key, profile) !== null));
  return [...keys].slice(0, MOST_PLOTTED);
}

/** The keys with this one added, or removed if it was there. */
export function toggled(keys: readonly PlotKeyText[], key: PlotKeyText): readonly PlotKeyText[] {
  return keys.includes(key) ? keys.filter((other) => other !== key) : [...keys, key];
}
