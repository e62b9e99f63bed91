import i18next, { type i18n as I18n } from "i18next";
import { initReactI18next } from "react-i18next";
import type { Language } from "../store/settings";
import en from "./en.json";
import enSaid from "./en-said.json";
import es from "./es.json";
import esSaid from "./es-said.json";

/** The fixed words of the page, and what it says: alarms, outcomes, problems. */
export const CATALOGUES = { es: { ...es, ...esSaid }, en: { ...en, ...enSaid } } as const;

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
