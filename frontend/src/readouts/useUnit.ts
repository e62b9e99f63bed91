import { useMemo } from "react";
import { useTranslation } from "react-i18next";
import { formatFixed } from "../lib/format";
import { convertUnit, type UnitName } from "../lib/units";
import { AS_SENT, type Quantity, unitChoice, unitDigits, usualUnit } from "../store/chosenUnits";
import { useSettings } from "../store/hooks";
import type { Format } from "./formats";

/** How one number of a quantity is shown: stable until another unit or language is chosen. */
export interface Unit {
  readonly name: UnitName;
  /** What stands behind the number. */
  readonly label: string;
  readonly digits: number;
  /** From the sender's unit into the shown one, and back for what a person has typed. */
  readonly convert: (sent: number) => number;
  readonly revert: (shown: number) => number;
  /** A number in the sender's unit as text in the shown one. */
  readonly format: Format;
}

/** The unit which the person chose for a quantity; `sent` is the one in which the numbers come. */
export function useUnit(quantity: Quantity, sent: UnitName = usualUnit(quantity)): Unit {
  const { t } = useTranslation();
  const choice = useSettings((settings) => unitChoice(settings, quantity));
  return useMemo(() => {
    const name = choice === AS_SENT ? sent : choice;
    const digits = unitDigits(quantity, name);
    const convert = (value: number): number => convertUnit(value, sent, name);
    return {
      name,
      label: t(`unit.${name}`),
      digits,
      convert,
      revert: (value) => convertUnit(value, name, sent),
      format: (value) => (value === null ? null : formatFixed(convert(value), digits)),
    };
  }, [t, quantity, sent, choice]);
}
