import { formatMeasured, WIRE_FIGURES } from "../../lib/format";
import type { InspectedFrame, InspectedRow } from "../../protocol/contract";
import type { XplaneProfile } from "../../protocol/messages.gen";
import type { DataState } from "../../store/telemetry";
import { fieldKey, ownKey, type PlotKeyText, rowKey, rowValue } from "./plotted";
import { unitSymbol } from "./unitSymbols";

/** One of a message's last values. */
export interface LineValue {
  readonly name: string;
  /** A number as text, or a flag; null is no data. */
  readonly value: string | boolean | null;
  readonly unit: string;
  /** Its key in the plot; null if it cannot be plotted. */
  readonly plotKey: PlotKeyText | null;
}

/** One message type or row, as the table shows it. */
export interface Line {
  readonly key: string;
  readonly id: string;
  /** Its name on the wire, the same as its topic and its name in recordings. */
  readonly name: string;
  readonly count: number;
  readonly rate_hz: number;
  readonly jitter_ms: number | null;
  readonly damaged: number;
  readonly age_s: number | null;
  readonly state: DataState;
  /** Whether the HIL loop needs it. */
  readonly isNeeded: boolean;
  readonly values: readonly LineValue[];
}

/** An older row is not live; the gateway forgets it then too. */
const ROW_STALE_AFTER_S = 1;
/** Type words from here on are of topics that the board describes itself. */
const FIRST_OWN = 0x1000;
/** X-Plane's mark for "no value". */
const ABSENT = -999;

function stateOf(age_s: number | null, stale_after_s: number | null): DataState {
  if (age_s === null) {
    return "none";
  }
  return stale_after_s !== null && age_s > stale_after_s ? "stale" : "live";
}

export function frameLine(frame: InspectedFrame): Line {
  return {
    ...frame,
    key: `frame.${frame.id}`,
    id: frame.id >= 0x100 ? `0x${frame.id.toString(16)}` : String(frame.id),
    state: stateOf(frame.age_s, frame.stale_after_s),
    isNeeded: false,
    values: Object.entries(frame.values ?? {}).map(([name, value]) => ({
      name,
      value: typeof value === "number" ? written(value) : value,
      unit: unitSymbol(frame.units[name] ?? ""),
      plotKey: plotKey(frame, name, value),
    })),
  };
}

function plotKey({ id, name: topic }: InspectedFrame, name: string, value: unknown): PlotKeyText | null {
  if (id < FIRST_OWN) {
    return fieldKey(topic, name);
  }
  return typeof value === "boolean" ? null : ownKey(topic, name);
}

/** The unit symbols of what the board's own topics hold, by the keys of their signals. */
export function ownUnits(frames: readonly InspectedFrame[]): ReadonlyMap<PlotKeyText, string> {
  return new Map(
    frames
      .filter(({ id }) => id >= FIRST_OWN)
      .flatMap(({ name: topic, units }) =>
        Object.entries(units).map(([name, unit]) => [ownKey(topic, name), unitSymbol(unit)] as const),
      ),
  );
}

export function rowLine(row: InspectedRow, profile: XplaneProfile): Line {
  return {
    ...row,
    key: `row.${row.row}`,
    id: String(row.row),
    damaged: 0,
    state: stateOf(row.age_s, ROW_STALE_AFTER_S),
    isNeeded: row.expected,
    values: (row.values ?? []).map((value, index) => {
      const known = rowValue(profile, row.row, index);
      return {
        name: known === null ? String(index) : `${index} ${known.name}`,
        value: value === null || value === ABSENT ? null : written(value),
        unit: known?.unit ?? "",
        plotKey: rowKey(row.row, index),
      };
    }),
  };
}

/** An integer has no decimals; any other number has the precision of the wire. */
function written(value: number): string | null {
  return Number.isInteger(value) ? String(value) : formatMeasured(value, WIRE_FIGURES);
}
