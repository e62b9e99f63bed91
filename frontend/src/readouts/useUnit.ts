import { useMemo } from "react";
import { useTranslation } from "react-i18next";
import { formatFixed } from "../lib/format";
import { convertUnit, type UnitName } from "../lib/units";
import { AS_SENT, type Quantity, unitChoice, unitDigits, usualUnit } from "../store/chosenUnits";
import { useSettings } from "../store/hooks";
import type { Format } from "./formats";

/** How to show a number of a quantity; stable until the unit or the language changes. */
export interface Unit {
  readonly name: UnitName;
  /** The symbol after the number. */
  readonly label: string;
  readonly digits: number;
  /** From the sender's unit to the shown one, and back for typed numbers. */
  readonly convert: (sent: number) => number;
  readonly revert: (shown: number) => number;
  /** A number in the sender's unit as text in the shown one. */
  readonly format: Format;
}

/** The user's unit for a quantity; `sent` is the unit of the received numbers. */
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
