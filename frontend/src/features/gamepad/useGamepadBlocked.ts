import { useTranslation } from "react-i18next";
import { useGatewayBlocked } from "../../requests/useBlocked";
import { useConnection } from "../../store/hooks";
import { STICK_AXES } from "./stickMapping";
import { useGamepads } from "./useGamepads";

/** Why this page's gamepad cannot fly now; undefined if it can. */
export function useGamepadBlocked(): string | undefined {
  const { t } = useTranslation();
  const gateway = useGatewayBlocked();
  const isEmulated = useConnection(({ status }) => status?.board.emulated === true);
  const hasControl = useConnection(
    ({ status, client }) => client !== null && status?.control.client === client,
  );
  const hasPad = useGamepads(({ selected, mapping }) => selected !== null && mapping !== null);
  const isComplete = useGamepads(({ mapping }) =>
    STICK_AXES.every((axis) => axis === "rudder" || mapping?.[axis].input !== null),
  );
  if (gateway !== undefined) {
    return gateway;
  }
  if (!hasControl) {
    return t("problem.stick_needs_control");
  }
  if (!hasPad) {
    return t("gamepad.none");
  }
  if (!isComplete) {
    return t("gamepad.incomplete");
  }
  return isEmulated ? t("problem.emulation_running") : undefined;
}
