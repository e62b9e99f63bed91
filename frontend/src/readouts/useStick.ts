import type { Connection } from "../store/connection";
import { useConnection } from "../store/hooks";

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
