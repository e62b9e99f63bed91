import { useTranslation } from "react-i18next";
import { STICK_AXES } from "../features/gamepad/stickMapping";
import { useGatewayBlocked } from "../requests/useBlocked";
import type { Connection } from "../store/connection";
import { useConnection, useGamepads } from "../store/hooks";

/** Where the stick comes from; `lost`: it is a gamepad whose samples do not come. */
export type StickKind = "simulator" | "gamepad" | "lost";

/** As the gateway says now; null while nobody knows. */
export function stickKind({ phase, status }: Connection): StickKind | null {
  const stick = phase === "open" ? status?.hil.stick : undefined;
  if (stick === undefined) {
    return null;
  }
  return stick.source === "gamepad" && stick.state === "lost" ? "lost" : stick.source;
}

export function useStickKind(): StickKind | null {
  return useConnection(stickKind);
}

/** The stick is a gamepad at this page. */
export function useStickIsMine(): boolean {
  return useConnection(
    ({ phase, status, client }) =>
      phase === "open" && client !== null && status?.hil.stick?.client === client,
  );
}

/** Why nobody can fly with this page's gamepad now, in a sentence; undefined when one can. */
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
