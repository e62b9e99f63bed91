import { createContext, useContext } from "react";

/** The dialogs that a menu or a key opens. */
export type DialogName =
  | "about"
  | "checklist"
  | "field"
  | "guide"
  | "log"
  | "settings"
  | "tablet"
  | "drawer"
  | "shortcuts"
  | "signal";

export interface Question {
  readonly title: string;
  readonly text: string;
  readonly confirm: string;
  readonly danger: boolean;
  readonly onConfirm: () => void;
}

export interface Dialogs {
  readonly open: (name: DialogName) => void;
  readonly close: () => void;
  /** Ask before an action that cannot be undone. */
  readonly ask: (question: Question) => void;
}

export const DialogsContext = createContext<Dialogs | null>(null);

export function useDialogs(): Dialogs {
  const dialogs = useContext(DialogsContext);
  if (dialogs === null) {
    throw new Error("DialogsProvider is missing above a part that opens windows");
  }
  return dialogs;
}
