import { useCallback } from "react";
import { useSentence } from "../i18n/useSentence";
import { feetFromMetres } from "../lib/units";
import type { HeightSet } from "../protocol/guards.gen";
import type { Message } from "../store/messages";
import { useUnit } from "./useUnit";

/** EGM96 gives the height of the sea with an error of about so much. */
const GEOID_WITHIN_M = 1;

/** By which heights something was judged, as a sentence; `write`: a height in feet with its unit. */
export function heightMessage(set: HeightSet, write: (height_ft: number) => string): Message {
  const { name, datum, geoid_m } = set;
  const off = write(feetFromMetres(Math.abs(geoid_m)));
  const within = write(feetFromMetres(GEOID_WITHIN_M));
  return {
    level: datum === null ? "warning" : "info",
    key: `heightSet.${datum ?? "unknown"}`,
    params: { name, off, within },
  };
}

/** The same in the person's language and unit. */
export function useHeightText(): (set: HeightSet) => string {
  const sentence = useSentence();
  const altitude = useUnit("altitude");
  return useCallback(
    (set) => sentence(heightMessage(set, (height_ft) => `${altitude.format(height_ft)} ${altitude.label}`)),
    [sentence, altitude],
  );
}
