import { useTranslation } from "react-i18next";
import { useRoleBlocked } from "../../../requests/useRole";
import { useIsPast } from "../../../store/hooks";

/** Why this person cannot change ground and fence now. */
export function useFixed(): string | undefined {
  const { t } = useTranslation();
  const role = useRoleBlocked("operator");
  return useIsPast() ? t("map.around.past") : role;
}
