import type { Inspection } from "../../protocol/contract";
import { useReread } from "../../requests/useReread";
import { usePart } from "../../store/hooks";
import type { Message } from "../../store/messages";
import { INSPECTOR } from "./inspectorRequests";

/** Twice a second; slightly less than five rounds of text, so that no round is missed. */
const PERIOD_MS = 480;

/** The links' statistics, read twice a second; a message when reading failed. */
export function useInspection(): Inspection | Message | null {
  return useReread(usePart(INSPECTOR).read, PERIOD_MS);
}
