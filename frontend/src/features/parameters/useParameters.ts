import { useStore } from "zustand";
import { usePart } from "../../store/hooks";
import type { ParameterValues } from "./parameterValues";
import { PARAMETER_REQUESTS } from "./parameterValues";

export function useParameters<T>(select: (values: ParameterValues) => T): T {
  return useStore(usePart(PARAMETER_REQUESTS).values, select);
}
