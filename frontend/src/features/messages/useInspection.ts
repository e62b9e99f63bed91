import { useEffect, useState } from "react";
import type { Inspection } from "../../protocol/contract";
import { usePage, usePart } from "../../store/hooks";
import type { Message } from "../../store/messages";
import { INSPECTOR } from "./inspectorRequests";

/** Twice a second; slightly less than five rounds of text, so that no round is missed. */
const PERIOD_MS = 480;

/**
 * The links' statistics, read twice a second while the tab is open and the page visible. Null until the first answer;
 * a message when reading failed.
 */
export function useInspection(): Inspection | Message | null {
  const { pump } = usePage();
  const inspector = usePart(INSPECTOR);
  const [found, setFound] = useState<Inspection | Message | null>(null);
  useEffect(() => {
    let isOpen = true;
    let isUnderWay = false;
    let asked_ms = Number.NEGATIVE_INFINITY;
    const stop = pump.add("text", (now_ms) => {
      if (isUnderWay || now_ms - asked_ms < PERIOD_MS) {
        return;
      }
      isUnderWay = true;
      asked_ms = now_ms;
      void inspector.read().then((answer) => {
        isUnderWay = false;
        if (isOpen) {
          setFound(answer);
        }
      });
    });
    return () => {
      isOpen = false;
      stop();
    };
  }, [inspector, pump]);
  return found;
}
