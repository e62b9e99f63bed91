/** Parsing of number fields, and the steps of their buttons. */

/**
 * A number as typed: digits with at most one comma or point, either of them the decimal mark. Thousands separators
 * are rejected on purpose: "1.234" must not be a thousand for one reader and one for another, in a gain of a control
 * loop.
 */
export function parseNumber(text: string): number | null {
  const plain = text.trim().replace("\u2212", "-").replace(",", ".");
  return /^[+-]?(\d+\.?\d*|\.\d+)$/.test(plain) ? Number(plain) : null;
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
