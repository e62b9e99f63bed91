import { useEffect } from "react";

const listeners = new Set<() => void>();

/** Calls `run` each time a dialog opens; the result unsubscribes. */
export function onDialogs(run: () => void): () => void {
  listeners.add(run);
  return () => {
    listeners.delete(run);
  };
}

/** For dialogs: what a hand holds must hear of them. */
export function useOpened(isOpen: boolean): void {
  useEffect(() => {
    if (isOpen) {
      for (const run of listeners) {
        run();
      }
    }
  }, [isOpen]);
}
