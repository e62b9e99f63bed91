import { useEffect } from "react";
import { useTranslation } from "react-i18next";
import { useConnection } from "../store/hooks";

/** Shows the state of the board's link in the window's title, where it is seen from other windows too. */
export function useTitle(): void {
  const { t } = useTranslation();
  const state = useConnection(({ status, phase }) =>
    phase === "open" ? (status?.board.state ?? "unknown") : "unknown",
  );
  const alarms = useConnection(({ status, phase }) => (phase === "open" ? (status?.alarms.length ?? 0) : 0));
  const title = t("frame.title", { state: t(`link.${state}`), name: t("app.name") });
  useEffect(() => {
    document.title = alarms === 0 ? title : `(${alarms}) ${title}`;
  }, [alarms, title]);
}
