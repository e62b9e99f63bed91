import { useEffect } from "react";
import { useTranslation } from "react-i18next";
import { useConnection } from "../store/hooks";

/** The window's title tells the state of the board's link, also to who looks at another window. */
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
