import type { Connection } from "../store/connection";
import { useConnection } from "../store/hooks";

/** Source of the stick; `lost`: a gamepad whose samples do not arrive. */
export type StickKind = "simulator" | "gamepad" | "lost";

/** As the gateway reports; null if unknown. */
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

/** Whether the stick is a gamepad at this page. */
export function useStickIsMine(): boolean {
  return useConnection(
    ({ phase, status, client }) =>
      phase === "open" && client !== null && status?.hil.stick?.client === client,
  );
}
