import { useEffect } from "react";
import { useStore } from "zustand";
import { useConnection, usePart } from "../../../store/hooks";
import { SURROUNDINGS, type SurroundingsState } from "./surroundings";

/** One value of ground and fence. */
export function useSurroundings<T>(select: (state: SurroundingsState) => T): T {
  return useStore(usePart(SURROUNDINGS).store, select);
}

/** Read the choice whenever a connection begins: somebody may have changed it meanwhile. */
export function useReadSurroundings(): void {
  const { read } = usePart(SURROUNDINGS);
  const isOpen = useConnection(({ phase }) => phase === "open");
  useEffect(() => {
    if (isOpen) {
      void read();
    }
  }, [read, isOpen]);
}
