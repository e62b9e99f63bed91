import { useEffect } from "react";
import { useTranslation } from "react-i18next";
import type { Status } from "../protocol/status";
import { useConnection } from "../store/hooks";

/** Shows the state of the board's link in the window's title, where it is seen from other windows too. */
export function useTitle(): void {
  const { t } = useTranslation();
  const state = useConnection(({ status, phase }) =>
    phase === "open" ? (status?.board.state ?? "unknown") : "unknown",
  );
  const alarms = useConnection(({ status, phase }) => (phase === "open" ? lasting(status) : 0));
  const title = t("window.title", { state: t(`link.${state}`), name: t("app.name") });
  useEffect(() => {
    document.title = alarms === 0 ? title : `(${alarms}) ${title}`;
  }, [alarms, title]);
}

/** Number of active alarms; the gateway also lists the recovered ones. */
function lasting(status: Status | null): number {
  return status?.alarms.filter(({ until_s }) => until_s === null).length ?? 0;
}
