import { useEffect } from "react";
import { useConnection } from "../store/hooks";

/** Who commands an open board is asked before the window closes: the browser asks in its own words. */
export function useLeaveWarning(): void {
  const isCommanding = useConnection(
    ({ status, phase, client }) =>
      phase === "open" &&
      status?.board.state === "open" &&
      client !== null &&
      status.control.client === client,
  );
  useEffect(() => {
    if (!isCommanding) {
      return;
    }
    const ask = (event: BeforeUnloadEvent): void => event.preventDefault();
    window.addEventListener("beforeunload", ask);
    return () => window.removeEventListener("beforeunload", ask);
  }, [isCommanding]);
}
