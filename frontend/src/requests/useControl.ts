import type { TFunction } from "i18next";
import { useTranslation } from "react-i18next";
import type { Connection } from "../store/connection";
import { useConnection } from "../store/hooks";

/** A page as others call it. `number` counts the pages of one session. */
export interface NamedPage {
  readonly client: string | null;
  readonly name: string | null;
  readonly kind: "local" | "person" | "program" | null;
  readonly number: number | null;
}

/** "Ana · tableta"; a page on the station's own computer is called so in the user's language. */
export function pageName(t: TFunction, { client, name, kind, number }: NamedPage): string {
  if (kind !== "local") {
    return name ?? client ?? "";
  }
  return number === null || number < 2 ? t("control.station") : t("control.stationPage", { number });
}

/** How the station calls whoever commands from its own computer; kept in recordings. */
export const THIS_COMPUTER = "this computer";

/** An operator's name of a recording; the station's own computer is named in the user's language. */
export function operatorName(t: TFunction, name: string | null): string | null {
  return name === THIS_COMPUTER ? t("control.station") : name;
}

/** The page that has control, if another one has it. */
export function otherHolder({ status, client }: Connection): NamedPage | null {
  const control = status?.control;
  return control?.client == null || control.client === client ? null : control;
}

/** Name of the page that has control, if another one has it. */
export function useOtherHolder(): string | null {
  const { t } = useTranslation();
  return useConnection((connection) => {
    const holder = otherHolder(connection);
    return holder === null ? null : pageName(t, holder);
  });
}
