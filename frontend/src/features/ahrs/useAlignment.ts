import { useStore } from "zustand";
import { usePart } from "../../store/hooks";
import type { Alignment } from "./alignment";
import { AHRS } from "./alignment";

export function useAlignment<T>(select: (alignment: Alignment) => T): T {
  return useStore(usePart(AHRS).alignment, select);
}
