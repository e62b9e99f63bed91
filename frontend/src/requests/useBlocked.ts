import { useTranslation } from "react-i18next";
import { useConnection, useIsPast } from "../store/hooks";
import { useOtherHolder } from "./useControl";
import { useRoleBlocked } from "./useRole";

/** Why no request can be sent to the gateway now; undefined if it can. While one looks at the past, nobody commands. */
export function useGatewayBlocked(): string | undefined {
  const { t } = useTranslation();
  const isOpen = useConnection(({ phase }) => phase === "open");
  const holder = useOtherHolder();
  const role = useRoleBlocked("operator");
  if (useIsPast()) {
    return t("blocked.past");
  }
  if (!isOpen) {
    return t("blocked.gateway");
  }
  return role ?? (holder === null ? undefined : t("blocked.viewer", { name: holder }));
}

/** Why no command can be sent to the board now; undefined if it can. */
export function useBoardBlocked(): string | undefined {
  const { t } = useTranslation();
  const gateway = useGatewayBlocked();
  const isOpen = useConnection(({ status }) => status?.board.state === "open");
  const isTesting = useConnection(({ status }) => (status?.board.ahrs_test ?? "off") !== "off");
  return gateway ?? (isOpen ? (isTesting ? t("ahrs3d.blocked") : undefined) : t("blocked.board"));
}
