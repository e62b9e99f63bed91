import { createStore, type StoreApi } from "zustand/vanilla";
import { isNumber, isText } from "../lib/check";

export type MessageLevel = "info" | "warning" | "error";
export type MessageParams = Readonly<Record<string, string | number>>;

/**
 * A sentence for the person: a key of the catalogue with what goes into it, translated where it is shown, so that it
 * changes its language with the page. `fallback` is the gateway's own sentence, for a key that this page does not know.
 */
export interface Message {
  readonly level: MessageLevel;
  readonly key: string;
  readonly params: MessageParams;
  readonly fallback?: string;
}

export interface SaidMessage extends Message {
  readonly number: number;
  /** Unix milliseconds, this browser's clock. */
  readonly said_ms: number;
}

export type MessageStore = StoreApi<{ readonly last: SaidMessage | null }>;

export function createMessages(): MessageStore {
  return createStore(() => ({ last: null }));
}

export function say(store: MessageStore, message: Message, said_ms: number): void {
  store.setState(({ last }) => ({ last: { ...message, number: (last?.number ?? 0) + 1, said_ms } }));
}

/** What the gateway says when something failed: a stable code, its sentence in English, the values in it. */
export interface Failure {
  readonly code: string;
  readonly detail: string;
  readonly params: Readonly<Record<string, unknown>>;
}

/** A failure as a message: translated by its code where the catalogue has that, else as the gateway says it. */
export function failureMessage({ code, detail, params }: Failure, level: MessageLevel = "error"): Message {
  return { level, key: `problem.${code}`, params: wordsOf(params), fallback: detail };
}

/** The values that can stand in a sentence. */
export function wordsOf(params: Readonly<Record<string, unknown>>): MessageParams {
  return Object.fromEntries(
    Object.entries(params).filter(
      (entry): entry is [string, string | number] => isText(entry[1]) || isNumber(entry[1]),
    ),
  );
}
