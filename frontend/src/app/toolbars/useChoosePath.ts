import { useTranslation } from "react-i18next";
import { ACTIONS } from "../../requests/actions";
import { usePage, usePart } from "../../store/hooks";
import { useDialogs } from "../views/useDialogs";

/**
 * Chooses the path of the control signal to X-Plane. If the autopilot flies, it asks first: the aircraft would follow
 * the stick at once, in whatever position it is.
 */
export function useChoosePath(): (path: "manual" | "assisted") => void {
  const { t } = useTranslation();
  const { connection, telemetry } = usePage();
  const actions = usePart(ACTIONS);
  const { ask } = useDialogs();
  return (path) => {
    const choose = (): void => void actions.setHil({ path }, { control: "path", asked: path });
    const isAssisted = connection.getState().status?.hil.path === "assisted";
    // Also by an old heartbeat: nobody has said since that the autopilot is off.
    const isFlying = telemetry.newestFlag("heartbeat", "autopilot_hil") === true;
    if (path === "manual" && isAssisted && isFlying) {
      ask({
        title: t("path.manualTitle"),
        text: t("path.manualText"),
        confirm: t("path.manualConfirm"),
        danger: true,
        onConfirm: choose,
      });
    } else {
      choose();
    }
  };
}
