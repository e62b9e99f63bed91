import { formatMeasured } from "../../lib/format";
import type { TelemetryStore } from "../../store/telemetry";
import { type PlotSeries, valueAt } from "./drawn";
import { parseSignal } from "./signalNames";

/** Whether all that a signal is made of arrives now. */
export function isFresh(telemetry: TelemetryStore, name: string, now_ms: number): boolean {
  return (parseSignal(name)?.operands ?? []).every((operand) => {
    const topic = operand.slice(0, operand.indexOf("."));
    return telemetry.state(topic, now_ms) === "live";
  });
}

/** The value at a moment as text: two numbers where a step holds more than one; null where there is none. */
export function valueText(drawn: PlotSeries, at_s: number | null): string | null {
  const moment_s = at_s ?? drawn.at_s.at(-1) ?? null;
  const found = moment_s === null ? null : valueAt(drawn, moment_s);
  if (found === null) {
    return null;
  }
  const [low, high] = [formatMeasured(found[0]), formatMeasured(found[1])];
  return low === high ? low : `${low} … ${high}`;
}
