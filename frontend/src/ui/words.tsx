import { createContext, type ReactNode, useContext } from "react";

/** Freshness of a value: received within three periods of its stream, older, or never received. */
export type DataState = "live" | "stale" | "none";

/** State of a request to the board. `sent`: it was sent, and nothing will ever prove its arrival. */
export type CommandState = "idle" | "pending" | "confirmed" | "rejected" | "timed_out" | "sent";

/** The few words of the controls themselves, in the page's language. */
export interface Words {
  live: string;
  stale: string;
  noData: string;
  pending: string;
  confirmed: string;
  rejected: string;
  timedOut: string;
  sent: string;
  on: string;
  off: string;
  unknown: string;
  increase: string;
  decrease: string;
  dismiss: string;
  close: string;
  warning: string;
  critical: string;
  /** A number field's complaint about text that is not a number. */
  notANumber: string;
  /** One mark and three digits behind it: which of two numbers is meant? */
  whichNumber: string;
  /** A number field's complaint about a number outside its range, which is given as text. */
  outOfRange: (minimum: string, maximum: string) => string;
  /** The value of a number field while another text is in it. */
  stillIs: (value: string) => string;
  /** A refused edit that is no longer shown. */
  refusedEdit: (text: string, why: string) => string;
  /** Why a form's button waits: the field with this label has an edit that was not taken. */
  openEdit: (label: string) => string;
}

const WordsContext = createContext<Words | null>(null);

export function WordsProvider({ words, children }: { words: Words; children: ReactNode }) {
  return <WordsContext value={words}>{children}</WordsContext>;
}

/** The words for a control. A missing provider is a mistake in the page and throws. */
export function useWords(): Words {
  const words = useContext(WordsContext);
  if (words === null) {
    throw new Error("WordsProvider is missing above a control");
  }
  return words;
}

export function dataWord(words: Words, state: DataState): string {
  return { live: words.live, stale: words.stale, none: words.noData }[state];
}

/** The word for a command's state; none when idle. */
export function commandWord(words: Words, state: CommandState): string {
  return {
    idle: "",
    pending: words.pending,
    confirmed: words.confirmed,
    rejected: words.rejected,
    timed_out: words.timedOut,
    sent: words.sent,
  }[state];
}
