import type { TFunction } from "i18next";
import { plain } from "../../lib/plain";
import { DEGREES_PER_RADIAN } from "../../lib/units";
import type { FaultChoice, FaultState } from "../../protocol/guards.gen";

/** How a strength is shown: by what the station's number is multiplied, and the unit's word. */
interface StrengthUnit {
  readonly factor: number;
  readonly word:
    | "deg"
    | "degPerS"
    | "degPerS2"
    | "kt"
    | "ktPerS"
    | "ft"
    | "ftPerS"
    | "m"
    | "mPerS"
    | "ms"
    | "percent"
    | "travel";
}

const UNITS: Readonly<Record<string, StrengthUnit>> = {
  "rad/s": { factor: DEGREES_PER_RADIAN, word: "degPerS" },
  "rad/s/s": { factor: DEGREES_PER_RADIAN, word: "degPerS2" },
  deg: { factor: 1, word: "deg" },
  "deg/s": { factor: 1, word: "degPerS" },
  kt: { factor: 1, word: "kt" },
  "kt/s": { factor: 1, word: "ktPerS" },
  ft: { factor: 1, word: "ft" },
  "ft/s": { factor: 1, word: "ftPerS" },
  m: { factor: 1, word: "m" },
  "m/s": { factor: 1, word: "mPerS" },
  ms: { factor: 1, word: "ms" },
  "1": { factor: 100, word: "percent" },
  "of half its travel": { factor: 100, word: "travel" },
};
const DIGITS = 3;

/** Null for a fault without a strength. */
export function shownUnit(unit: string): StrengthUnit | null {
  return UNITS[unit] ?? null;
}

/** A strength of the station as a person reads it, to three digits. */
export function shownStrength(strength: number, unit: string): number {
  return Number((strength * (shownUnit(unit)?.factor ?? 1)).toPrecision(DIGITS));
}

/** What a person typed as the station takes it, within the range that was rounded for showing. */
export function askedStrength(typed: number, { unit, lowest, highest }: FaultChoice): number {
  return Math.min(highest, Math.max(lowest, typed / (shownUnit(unit)?.factor ?? 1)));
}

type Named = Pick<FaultState, "place" | "kind">;

/** "Airspeed (pitot): constant error". */
export function faultName(t: TFunction, { place, kind }: Named): string {
  return t("faults.name", { place: t(`faultPlace.${place}`), kind: t(`faultKind.${kind}`) });
}

/** Its name and strength. */
export function faultSentence(t: TFunction, fault: FaultState): string {
  const unit = shownUnit(fault.unit);
  return fault.strength === null || unit === null
    ? faultName(t, fault)
    : t("faults.withStrength", {
        name: faultName(t, fault),
        strength: shownStrength(fault.strength, fault.unit),
        unit: t(`faultUnit.${unit.word}`),
      });
}

/** The choices whose words hold each of these words, by place in the table's order. */
export function grouped(
  t: TFunction,
  choices: readonly FaultChoice[],
  search: string,
): ReadonlyMap<FaultChoice["place"], readonly FaultChoice[]> {
  const words = plain(search).split(/\s+/).filter(Boolean);
  const groups = new Map<FaultChoice["place"], FaultChoice[]>();
  for (const choice of choices) {
    const name = plain(faultName(t, choice));
    if (words.every((word) => name.includes(word))) {
      groups.set(choice.place, [...(groups.get(choice.place) ?? []), choice]);
    }
  }
  return groups;
}
