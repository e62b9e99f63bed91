import { useTranslation } from "react-i18next";
import { isFlownByAutopilot } from "../../missions/planFacts";
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
    if (path === "manual" && isAssisted && isFlownByAutopilot(telemetry, "hil")) {
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
