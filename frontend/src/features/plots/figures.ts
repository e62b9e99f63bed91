import { formatMeasured } from "../../lib/format";
import { type Drawn, valueAt } from "./drawn";

/** The value at a moment as text: two numbers where a step holds more than one; null where there is none. */
export function valueText(drawn: Drawn, at_s: number | null): string | null {
  const moment_s = at_s ?? drawn.at_s.at(-1) ?? null;
  const found = moment_s === null ? null : valueAt(drawn, moment_s);
  if (found === null) {
    return null;
  }
  const [low, high] = [formatMeasured(found[0]), formatMeasured(found[1])];
  return low === high ? low : `${low} … ${high}`;
}
