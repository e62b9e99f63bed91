import { useEffect } from "react";
import { useTranslation } from "react-i18next";
import type { Status } from "../protocol/status";
import { useConnection } from "../store/hooks";

/** The window's title tells the state of the board's link, also to who looks at another window. */
export function useTitle(): void {
  const { t } = useTranslation();
  const state = useConnection(({ status, phase }) =>
    phase === "open" ? (status?.board.state ?? "unknown") : "unknown",
  );
  const alarms = useConnection(({ status, phase }) => (phase === "open" ? lasting(status) : 0));
  const title = t("frame.title", { state: t(`link.${state}`), name: t("app.name") });
  useEffect(() => {
    document.title = alarms === 0 ? title : `(${alarms}) ${title}`;
  }, [alarms, title]);
}

/** How many alarms last; the gateway also lists what recovered. */
function lasting(status: Status | null): number {
  return status?.alarms.filter(({ until_s }) => until_s === null).length ?? 0;
}
