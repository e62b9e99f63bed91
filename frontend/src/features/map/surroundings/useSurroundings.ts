import { useEffect } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useRoleBlocked } from "../../../requests/useRole";
import { useConnection, useIsPast, usePart } from "../../../store/hooks";
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

/** Why this person cannot change ground and fence now. */
export function useFixed(): string | undefined {
  const { t } = useTranslation();
  const role = useRoleBlocked("operator");
  return useIsPast() ? t("map.around.past") : role;
}
