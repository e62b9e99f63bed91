import "i18next";
import type { CATALOGUES } from "./catalogues";

declare module "i18next" {
  interface CustomTypeOptions {
    resources: { translation: (typeof CATALOGUES)["es"] };
    returnNull: false;
  }
}
