import { useCallback, useEffect, useMemo } from "react";
import { useTranslation } from "react-i18next";
import type { PickedAirfield } from "../../../lib/aircraft";
import { SELECTION, selectThing } from "../../../missions/selection";
import type { Light } from "../../../scene/look";
import { type CountryNames, countryNames } from "../../../scene/names/thingTexts";
import { usePart, useSettings } from "../../../store/hooks";
import { useGlobeLayer } from "./useGlobe";
import { useGraticule } from "./useGraticule";

export const LIGHT_CHOICE = "map.light";

/** Whether the drawn ground looks as by day or as by night. */
export function useLight(): Light {
  return useSettings(({ choices }) => (choices[LIGHT_CHOICE] === "night" ? "night" : "day"));
}

/** Names of countries in the page's language. */
export function useCountries(): CountryNames {
  const { i18n } = useTranslation();
  return useMemo(() => countryNames(i18n.language), [i18n.language]);
}

/** Selects a pressed airfield: its card is shown. */
export function usePickAirfield(): (picked: PickedAirfield) => void {
  const mapSelection = usePart(SELECTION);
  return useCallback((picked) => selectThing(mapSelection, { kind: "airfield", ...picked }), [mapSelection]);
}

/** Shows the names of towns, airfields and navigation aids on the globe. */
export function useGlobeNames(): void {
  const names = useGlobeLayer(
    "names",
    async () => (await import("../../../scene/names/GlobeNames")).GlobeNames,
  );
  const light = useLight();
  const countries = useCountries();
  const graticule = useGraticule();
  const pick = usePickAirfield();
  useEffect(() => names?.set(light, countries, graticule), [names, light, countries, graticule]);
  useEffect(() => {
    names?.onAirfield(pick);
    return () => names?.onAirfield(null);
  }, [names, pick]);
}
