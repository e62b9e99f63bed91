import { useTranslation } from "react-i18next";
import { XPLANE_ROWS } from "../../protocol/messages.gen";

/** Names of X-Plane's rows by number; an unknown row has none. */
const NAMES = new Map(XPLANE_ROWS.xp10.map(({ id, name }) => [id, name]));

export function useRowName(row: number): string {
  const { t, i18n } = useTranslation();
  const name = NAMES.get(row);
  const key = `simulatorRow.${name}`;
  return name !== undefined && i18n.exists(key) ? t(key as "simulatorRow.speeds") : t("words.dash");
}
