import { createContext, useContext } from "react";

/** Tells the user why a press did nothing: a sentence in the page's language. */
export type Refuse = (reason: string) => void;

const RefusalContext = createContext<Refuse>(() => undefined);

/** The place where presses on greyed controls are answered. */
export const RefusalProvider = RefusalContext.Provider;

export function useRefuse(): Refuse {
  return useContext(RefusalContext);
}

/**
 * What a control does with a press: run it, or answer with the reason why the control cannot be used. A greyed control
 * takes every press, because its reason may come or go between the moment it is seen and the moment it is pressed.
 */
export function usePress(disabledReason: string | undefined): (run: () => void) => void {
  const refuse = useRefuse();
  return (run) => (disabledReason === undefined ? run() : refuse(disabledReason));
}
