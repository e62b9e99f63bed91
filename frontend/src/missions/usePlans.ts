import { useStore } from "zustand";
import { usePart } from "../store/hooks";
import type { Plans } from "./planDrafts";
import { MISSIONS } from "./planDrafts";

export function usePlans<T>(select: (plans: Plans) => T): T {
  return useStore(usePart(MISSIONS).plans, select);
}
