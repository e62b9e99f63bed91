/** Parsing of number fields, and the steps of their buttons. */

/**
 * A number as typed: digits with at most one comma or point, either of them the decimal mark. Whether "1.234" may be a
 * thousand as well says `twoReadings`, which knows the range.
 */
export function parseNumber(text: string): number | null {
  const plain = text.trim().replace("\u2212", "-").replace(",", ".");
  return /^[+-]?(\d+\.?\d*|\.\d+)$/.test(plain) ? Number(plain) : null;
}

const THOUSANDS = /^[+-]?[1-9]\d{0,2}[.,]\d{3}$/;

/** What "1.000" or "1,000" may mean: a thousand for the one who typed it, one for the program. As they are to be typed. */
export interface TwoReadings {
  readonly thousand: string;
  readonly one: string;
}

/**
 * The two readings of a number that was typed with one mark and three digits behind it; null where only one is possible,
 * because a thousand times as much is out of the range, as in coordinates and most gains.
 */
export function twoReadings(text: string, minimum: number, maximum: number): TwoReadings | null {
  const plain = text.trim().replace("\u2212", "-");
  const thousand = plain.replace(/[.,]/, "");
  const isPossible = Number(thousand) >= minimum && Number(thousand) <= maximum;
  return THOUSANDS.test(plain) && isPossible
    ? { thousand, one: String(Number(plain.replace(",", "."))) }
    : null;
}

/** One step up or down from `value`, rounded to the step's decimals (0.1 + 0.2 is 0.3) and within the range. */
export function stepped(
  value: number,
  step: number,
  direction: 1 | -1,
  minimum: number,
  maximum: number,
): number {
  const decimals = Math.max(decimalsOf(step), decimalsOf(value));
  const moved = Number((value + direction * step).toFixed(decimals));
  return Math.min(maximum, Math.max(minimum, moved));
}

/** Decimals of a number as it is written, at most ten. */
function decimalsOf(value: number): number {
  const text = String(value);
  const exponent = /e-(\d+)$/.exec(text);
  const written = /\.(\d+)/.exec(text)?.[1]?.length ?? 0;
  return Math.min(10, written + (exponent === null ? 0 : Number(exponent[1])));
}
