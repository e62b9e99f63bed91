import i18next, { type i18n as I18n } from "i18next";
import { initReactI18next } from "react-i18next";
import type { Language } from "../store/settings";
import en from "./en.json";
import enAhrs3d from "./en-ahrs3d.json";
import enAlarms from "./en-alarms.json";
import enFrame from "./en-frame.json";
import enGamepad from "./en-gamepad.json";
import enHelp from "./en-help.json";
import enMap from "./en-map.json";
import enMessages from "./en-messages.json";
import enParams from "./en-params.json";
import enPlans from "./en-plans.json";
import enSaid from "./en-said.json";
import enSix from "./en-six.json";
import es from "./es.json";
import esAhrs3d from "./es-ahrs3d.json";
import esAlarms from "./es-alarms.json";
import esFrame from "./es-frame.json";
import esGamepad from "./es-gamepad.json";
import esHelp from "./es-help.json";
import esMap from "./es-map.json";
import esMessages from "./es-messages.json";
import esParams from "./es-params.json";
import esPlans from "./es-plans.json";
import esSaid from "./es-said.json";
import esSix from "./es-six.json";

/** The fixed words of the page, and what it says: alarms, outcomes, problems. One file for each part of the page. */
export const CATALOGUES = {
  es: {
    ...es,
    ...esSaid,
    ...esFrame,
    ...esGamepad,
    ...esSix,
    ...esParams,
    ...esPlans,
    ...esMap,
    ...esMessages,
    ...esAhrs3d,
    ...esAlarms,
    ...esHelp,
  },
  en: {
    ...en,
    ...enSaid,
    ...enFrame,
    ...enGamepad,
    ...enSix,
    ...enParams,
    ...enPlans,
    ...enMap,
    ...enMessages,
    ...enAhrs3d,
    ...enAlarms,
    ...enHelp,
  },
} as const;

/** The page's catalogues, both bundled: a change of language asks nobody for anything. */
export function createI18n(language: Language): I18n {
  const instance = i18next.createInstance();
  void instance.use(initReactI18next).init({
    lng: language,
    fallbackLng: false,
    initAsync: false,
    resources: { es: { translation: CATALOGUES.es }, en: { translation: CATALOGUES.en } },
    interpolation: { escapeValue: false },
    react: { useSuspense: false },
    returnNull: false,
  });
  return instance;
}
