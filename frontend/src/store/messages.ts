import { createStore, type StoreApi } from "zustand/vanilla";
import { isNumber, isText } from "../lib/check";

export type MessageLevel = "info" | "warning" | "error";
export type MessageParams = Readonly<Record<string, string | number>>;

/**
 * A message to the user: a key of the catalogue and its parameters, translated where it is shown, so that it follows
 * the page's language. `fallback` is the gateway's own text, for a key that this page does not know.
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

/** A failure reported by the gateway: a stable code, an English sentence, its values. */
export interface Failure {
  readonly code: string;
  readonly detail: string;
  readonly params: Readonly<Record<string, unknown>>;
}

/** A failure as a message: translated by its code if the catalogue has it, else the gateway's text. */
export function failureMessage({ code, detail, params }: Failure, level: MessageLevel = "error"): Message {
  return { level, key: `problem.${code}`, params: wordsOf(params), fallback: detail };
}

/** The values that can be inserted into a sentence. */
export function wordsOf(params: Readonly<Record<string, unknown>>): MessageParams {
  return Object.fromEntries(
    Object.entries(params).filter(
      (entry): entry is [string, string | number] => isText(entry[1]) || isNumber(entry[1]),
    ),
  );
}
