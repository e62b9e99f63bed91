import type { UnitName } from "../lib/units";
import { choose, type Settings, type SettingsStore } from "./settings";

/** The quantities whose units the user can choose, each separately. */
export const QUANTITIES = ["altitude", "speed", "verticalSpeed", "distance", "temperature"] as const;
export type Quantity = (typeof QUANTITIES)[number];

/** The units of each quantity with their decimals; the first is the usual one. */
const UNITS: Readonly<Record<Quantity, ReadonlyArray<readonly [UnitName, number]>>> = {
  altitude: [
    ["ft", 0],
    ["m", 1],
  ],
  speed: [
    ["kt", 1],
    ["kmPerH", 1],
    ["mPerS", 1],
  ],
  verticalSpeed: [
    ["ftPerMin", 0],
    ["mPerS", 1],
  ],
  distance: [
    ["m", 0],
    ["km", 2],
    ["nm", 2],
  ],
  temperature: [
    ["degC", 1],
    ["degF", 1],
  ],
};

/** Each number keeps the unit in which it was sent. */
export const AS_SENT = "sent";
export type UnitChoice = UnitName | typeof AS_SENT;

export function unitsOf(quantity: Quantity): readonly UnitName[] {
  return UNITS[quantity].map(([unit]) => unit);
}

/** The usual unit of a quantity: the default of `useUnit`. */
export function usualUnit(quantity: Quantity): UnitName {
  return UNITS[quantity][0]?.[0] ?? fail(quantity);
}

/** Decimals of a unit, no more than the sensors resolve. */
export function unitDigits(quantity: Quantity, unit: UnitName): number {
  return UNITS[quantity].find(([name]) => name === unit)?.[1] ?? 0;
}

/**
 * Until somebody chooses, a quantity has one unit on every screen, whatever the board and the simulator send. Distances
 * keep theirs: metres near the aircraft, miles of a whole flight.
 */
const UNCHOSEN: Readonly<Record<Quantity, UnitChoice>> = {
  altitude: usualUnit("altitude"),
  speed: usualUnit("speed"),
  verticalSpeed: usualUnit("verticalSpeed"),
  distance: AS_SENT,
  temperature: usualUnit("temperature"),
};

export function unitChoice({ choices }: Settings, quantity: Quantity): UnitChoice {
  const chosen = choices[`unit.${quantity}`];
  const units: readonly UnitChoice[] = [AS_SENT, ...unitsOf(quantity)];
  return units.find((unit) => unit === chosen) ?? UNCHOSEN[quantity];
}

export function chooseUnit(store: SettingsStore, quantity: Quantity, unit: UnitChoice): void {
  choose(store, `unit.${quantity}`, unit);
}

/** Unit suffixes of the wire's names; longer ones first. */
const ENDINGS: ReadonlyArray<readonly [string, UnitName]> = [
  ["_ft_min", "ftPerMin"],
  ["_ft", "ft"],
  ["_kt", "kt"],
  ["_m", "m"],
  ["_degc", "degC"],
];

/** The unit of a field, from its name's suffix. Throws for a name without one: a mistake in the page. */
export function unitOfField(field: string): UnitName {
  return ENDINGS.find(([ending]) => field.endsWith(ending))?.[1] ?? fail(field);
}

function fail(what: string): never {
  throw new Error(`${what} has no unit that can be chosen`);
}
