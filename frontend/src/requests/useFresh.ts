import { useEffect } from "react";
import { useConnection } from "../store/hooks";

/** Have `refresh` read what the gateway knows while this is shown: at once, and each time the page has the station again. */
export function useFresh(refresh: () => Promise<void>): void {
  const isOpen = useConnection(({ phase }) => phase === "open");
  const client = useConnection((connection) => connection.client);
  useEffect(() => {
    if (isOpen && client !== null) {
      void refresh();
    }
  }, [refresh, isOpen, client]);
}
