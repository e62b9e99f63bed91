import { useTranslation } from "react-i18next";
import { ACTIONS } from "../requests/actions";
import { usePage, usePart } from "../store/hooks";
import { useDialogs } from "./dialogs/dialogs";

/**
 * Chooses which way the control signal takes to X-Plane. Away from an autopilot that flies it asks first: the aircraft
 * would follow the stick at once, wherever that stands.
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
