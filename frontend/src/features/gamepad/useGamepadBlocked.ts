import { useTranslation } from "react-i18next";
import { useGatewayBlocked } from "../../requests/useBlocked";
import { useConnection, useTelemetry } from "../../store/hooks";
import { useGamepads } from "./gamepadList";
import { STICK_AXES } from "./stickMapping";
import { TOUCH_PAD } from "./touchStick";

/** Why the stick on this page's screen cannot fly now; undefined if it can. */
export function useTouchBlocked(): string | undefined {
  const { t } = useTranslation();
  const gateway = useGatewayBlocked();
  const hasControl = useConnection(
    ({ status, client }) => client !== null && status?.control.client === client,
  );
  const isEmulated = useConnection(({ status }) => status?.board.emulated === true);
  const isSimulated = useConnection(({ status }) => status?.simulator.state === "open");
  // By a late heartbeat too: nobody has said that RC is the source, and the finger must not lose the stick for it.
  const isJoystick = useTelemetry((telemetry) => telemetry.newestFlag("heartbeat", "source_joystick"));
  const other = useConnection(({ status }) => otherGamepad(status?.hil.stick?.gamepad));
  if (gateway !== undefined) {
    return gateway;
  }
  if (!hasControl) {
    return t("problem.stick_needs_control");
  }
  if (isEmulated) {
    return t("problem.emulation_running");
  }
  if (!isSimulated) {
    return t("touchStick.noSimulator");
  }
  if (isJoystick !== true) {
    return t("touchStick.notJoystick");
  }
  return other === null ? undefined : t("touchStick.otherFlies", { gamepad: other });
}

function otherGamepad(flying: string | null | undefined): string | null {
  return flying === undefined || flying === TOUCH_PAD.id ? null : flying;
}

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
  const awaited = useAwaitedAxes();
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
  return isEmulated ? t("problem.emulation_running") : awaited;
}

/** The axes whose position is waited for, in a sentence; undefined if there are none. */
export function useAwaitedAxes(): string | undefined {
  const { t } = useTranslation();
  const awaited = useGamepads((state) => state.awaited);
  return awaited.length === 0
    ? undefined
    : t("gamepad.awaited", { axes: awaited.map((axis) => t(`control.${axis}`)).join(", ") });
}
