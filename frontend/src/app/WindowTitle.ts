import { useEffect } from "react";
import { useTranslation } from "react-i18next";
import { moment_s } from "../features/playback/playbackState";
import { usePlayback } from "../features/playback/usePlayback";
import { formatDateTime } from "../lib/moment";
import type { Status } from "../protocol/contract";
import { useConnection } from "../store/hooks";

/**
 * The window's title, which is seen from other windows too: that the past is shown and which, or the state of the
 * board's link; and the number of alarms of the present. A component of its own, for while a flight is played it changes
 * with each second, and only what renders with it is rendered again.
 */
export function WindowTitle(): null {
  const { t } = useTranslation();
  const state = useConnection(({ status, phase }) =>
    phase === "open" ? (status?.board.state ?? "unknown") : "unknown",
  );
  const alarms = useConnection(({ status, phase }) => (phase === "open" ? lasting(status) : 0));
  const title = t("window.title", { state: t(`link.${state}`), name: t("app.name") });
  // Whole seconds: the title must not change with every message of a flight that plays.
  const past_s = usePlayback((playback) =>
    playback.flight === null ? null : Math.floor(moment_s(playback) ?? 0),
  );
  const shown =
    past_s === null
      ? title
      : t("time.title", { clock: past_s === 0 ? "" : formatDateTime(past_s), title: t("app.name") });
  useEffect(() => {
    document.title = alarms === 0 ? shown : `(${alarms}) ${shown}`;
  }, [alarms, shown]);
  return null;
}

/** Number of active alarms; the gateway also lists the recovered ones. */
function lasting(status: Status | null): number {
  return status?.alarms.filter(({ until_s }) => until_s === null).length ?? 0;
}
