import { createStore, type StoreApi } from "zustand/vanilla";

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
