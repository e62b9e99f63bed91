import i18next, { type i18n as I18n, type ResourceKey } from "i18next";
import { initReactI18next } from "react-i18next";
import type { Language } from "../store/settings";

/** The words of each language; a feature's words are in its own folder. */
export type Catalogues = Readonly<Record<Language, ResourceKey>>;

/** Both languages are bundled: a change of language loads nothing. */
export function createI18n(catalogues: Catalogues, language: Language): I18n {
  const instance = i18next.createInstance();
  void instance.use(initReactI18next).init({
    lng: language,
    fallbackLng: false,
    initAsync: false,
    resources: { es: { translation: catalogues.es }, en: { translation: catalogues.en } },
    interpolation: { escapeValue: false },
    react: { useSuspense: false },
    returnNull: false,
  });
  return instance;
}
