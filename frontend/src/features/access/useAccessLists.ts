import { useEffect } from "react";
import { useStore } from "zustand";
import { usePart } from "../../store/hooks";
import { ACCESS_ADMIN, type AccessAdmin, type AccessLists } from "./accessAdmin";

export function useAccessAdmin(): AccessAdmin {
  return usePart(ACCESS_ADMIN);
}

/** One value of the lists; the component renders again when it changes. */
export function useAccessLists<T>(select: (lists: AccessLists) => T): T {
  return useStore(useAccessAdmin().store, select);
}

/** Keeps the lists fresh while the component is shown. */
export function useFreshLists(): void {
  const { watch } = useAccessAdmin();
  useEffect(() => watch(), [watch]);
}
