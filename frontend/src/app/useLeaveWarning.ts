import { useEffect } from "react";
import { useConnection } from "../store/hooks";

/** Asks before the browser tab closes while this page has control of an open board. The browser words the question. */
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
