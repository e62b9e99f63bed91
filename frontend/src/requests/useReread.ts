import { useEffect, useState } from "react";
import { usePage } from "../store/hooks";

/** What `read` gives, asked again every `period_ms` while it is shown and the page visible; null until the first answer. */
export function useReread<T>(read: () => Promise<T>, period_ms: number): T | null {
  const { pump } = usePage();
  const [found, setFound] = useState<T | null>(null);
  useEffect(() => {
    let isOpen = true;
    let isUnderWay = false;
    let asked_ms = Number.NEGATIVE_INFINITY;
    const stop = pump.add("text", (now_ms) => {
      if (isUnderWay || now_ms - asked_ms < period_ms) {
        return;
      }
      isUnderWay = true;
      asked_ms = now_ms;
      void read().then((answer) => {
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
  }, [read, period_ms, pump]);
  return found;
}
