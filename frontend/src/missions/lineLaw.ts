import { useSyncExternalStore } from "react";
import { useFresh } from "../requests/useFresh";
import { usePart } from "../store/hooks";
import { partName } from "../store/parts";

/** What the map draws of the law that holds the line. */
export interface LineLaw {
  /** Bank, degrees, of the turns that it flies; null: another law flies, or it is not known which. */
  readonly bank_deg: () => number | null;
  readonly subscribe: (listener: () => void) => () => void;
  /** Read what the gateway knows of it; nothing is asked of the board. */
  readonly refresh: () => Promise<void>;
}

/** Of a board that tells nothing of it, and of the past, in which only the 17 gains are known. */
export const UNKNOWN_LINE_LAW: LineLaw = {
  bank_deg: () => null,
  subscribe: () => () => undefined,
  refresh: () => Promise.resolve(),
};

export const LINE_LAW = partName<LineLaw>("line law");

/** The bank of the line law's turns; null: it does not fly, or that is not known. */
export function useTurnBank(): number | null {
  const law = usePart(LINE_LAW);
  return useSyncExternalStore(law.subscribe, law.bank_deg);
}

/** Have the line law known while this is shown. */
export function useFreshLineLaw(): void {
  useFresh(usePart(LINE_LAW).refresh);
}
