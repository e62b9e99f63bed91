import { useEffect } from "react";
import { GuardedCalls } from "../lib/guardedCalls";

const listeners = new Set<() => void>();
const calls = new GuardedCalls((error) => reportError(error));

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
      calls.each(listeners, (run) => run());
    }
  }, [isOpen]);
}
