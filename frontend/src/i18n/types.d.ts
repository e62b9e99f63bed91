import "i18next";
import type { CATALOGUES } from "./i18n";

declare module "i18next" {
  interface CustomTypeOptions {
    resources: { translation: (typeof CATALOGUES)["es"] };
    returnNull: false;
  }
}
