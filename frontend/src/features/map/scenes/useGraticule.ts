import { useMemo } from "react";
import { useTranslation } from "react-i18next";
import type { CompassLetters } from "../../../scene/globe/chart/graticule";
import { useSettings } from "../../../store/hooks";

export const GRATICULE_CHOICE = "map.graticule";

/** The graticule's compass letters in the page's language; null if it is switched off. */
export function useGraticule(): CompassLetters | null {
  const { t } = useTranslation();
  const isWanted = useSettings(({ choices }) => choices[GRATICULE_CHOICE] !== "off");
  const letters = t("map.view.compass");
  return useMemo(() => {
    const [north = "", east = "", south = "", west = ""] = letters;
    return isWanted ? { north, east, south, west } : null;
  }, [isWanted, letters]);
}
