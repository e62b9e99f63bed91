/** How a signal is made of recorded ones, as the gateway names it. */
export type Derivation = "rate" | "diff" | "error";

export interface ParsedSignal {
  /** Null: a recorded signal. */
  readonly derivation: Derivation | null;
  /** Recorded signals, `topic.field`. */
  readonly operands: readonly string[];
}

const RECORDED = /^[A-Za-z0-9_]+\.[A-Za-z0-9_]+$/;
const DERIVED = /^(rate|diff|error)\(([^()]*)\)$/;
/** Signals that each derivation is made of. */
const OPERANDS: Readonly<Record<Derivation, number>> = { rate: 1, diff: 2, error: 2 };

/** `topic.field`, `rate(a)`, `diff(a,b)` or `error(a,target)`; null for anything else. */
export function parseSignal(name: string): ParsedSignal | null {
  if (RECORDED.test(name)) {
    return { derivation: null, operands: [name] };
  }
  const [, derivation, inside] = DERIVED.exec(name) ?? [];
  if (derivation !== "rate" && derivation !== "diff" && derivation !== "error") {
    return null;
  }
  const operands = (inside ?? "").split(",");
  return operands.length === OPERANDS[derivation] && operands.every((one) => RECORDED.test(one))
    ? { derivation, operands }
    : null;
}

export function derivedName(derivation: Derivation, operands: readonly string[]): string {
  return `${derivation}(${operands.join(",")})`;
}

/** The name as people read it: "Δ a − b", "d/dt a", "ε b − a". */
export function signalLabel(name: string): string {
  const parsed = parseSignal(name);
  const [one = "", other = ""] = (parsed?.operands ?? []).map(shownName);
  switch (parsed?.derivation) {
    case "rate":
      return `d/dt ${one}`;
    case "diff":
      return `${one} − ${other}`;
    case "error":
      return `${other} − ${one}`;
    default:
      return shownName(name);
  }
}

const SYMBOLS: ReadonlyArray<readonly [RegExp, string]> = [
  [/^1$/, ""],
  [/^degc/, "°C"],
  [/^deg/, "°"],
  [/m\/s2/, "m/s²"],
  [/ft_min/, "ft/min"],
];

/** A unit of the definition as people write it. */
export function unitSymbol(unit: string): string {
  return SYMBOLS.reduce((text, [pattern, symbol]) => text.replace(pattern, symbol), unit);
}

/** A signal's name with the unit that it is shown in: what was converted to degrees is not called `_rad_s`. */
export function shownName(name: string): string {
  return name.replace(/_rad(?=_|\b)/g, "_deg");
}

/** Rates in radians are read in degrees everywhere in the page. */
export function shownUnit(unit: string): { readonly unit: string; readonly factor: number } {
  return unit.startsWith("rad")
    ? { unit: `deg${unit.slice(3)}`, factor: 180 / Math.PI }
    : { unit, factor: 1 };
}
