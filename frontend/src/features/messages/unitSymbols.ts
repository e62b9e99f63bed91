/** Units of the definition that are written otherwise where people read them. */
const SYMBOLS: Readonly<Record<string, string>> = {
  "1": "",
  deg: "°",
  "deg/s": "°/s",
  "m/s2": "m/s²",
  degC: "°C",
};

/** "deg" of the definition -> "°"; nothing for a number that has no unit. */
export function unitSymbol(unit: string): string {
  return SYMBOLS[unit] ?? unit;
}
