/** Symbols of the definition's units, where they differ from their names. */
const SYMBOLS: Readonly<Record<string, string>> = {
  "1": "",
  deg: "°",
  "deg/s": "°/s",
  "m/s2": "m/s²",
  degC: "°C",
};

/** "deg" -> "°"; empty for a number without a unit. */
export function unitSymbol(unit: string): string {
  return SYMBOLS[unit] ?? unit;
}
