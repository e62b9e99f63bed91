import { createStore, type StoreApi } from "zustand/vanilla";
import { isNumber, isObject, isText } from "../lib/check";
import type { Timers } from "../lib/timers";
import type { BrowserStorage } from "./settings";

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

/** `last` is what the status bar shows, `waiting` what it shows next; `kept` is what was said in this browser tab, oldest first, over reloads too. */
export interface Messages {
  readonly last: SaidMessage | null;
  readonly kept: readonly SaidMessage[];
  readonly waiting: SaidMessage | null;
  /** Whether `last` tells the user why what they did was not done. */
  readonly isRefusal: boolean;
}

export type MessageStore = StoreApi<Messages>;

/** Some 100 kB in the tab's storage, and more than anybody reads. */
export const MOST_KEPT = 500;
const KEY = "epf-gcs.messages";

export function createMessages(storage: BrowserStorage | null = null): MessageStore {
  const kept = read(storage);
  const store = createStore<Messages>(() => ({ last: null, kept, waiting: null, isRefusal: false }));
  store.subscribe(({ kept: now }, { kept: before }) => {
    if (now !== before) {
      write(storage, now);
    }
  });
  return store;
}

/** How long an information that nobody asked for leaves the answer to a press that failed in the status bar. */
export const READABLE_MS = 5000;

/** The answer to what the user did: the status bar shows it at once. */
export function say(store: MessageStore, message: Message, said_ms: number): void {
  const last = keep(store, message, said_ms);
  store.setState({ last, waiting: null, isRefusal: message.level !== "info" });
}

/** What happened by itself. An information waits until a refusal could be read; a warning or an error does not. */
export function announce(store: MessageStore, timers: Timers, message: Message, said_ms: number): void {
  const said = keep(store, message, said_ms);
  const { last, waiting, isRefusal } = store.getState();
  const age_ms = last === null ? READABLE_MS : said_ms - last.said_ms;
  if (message.level !== "info" || !isRefusal || age_ms < 0 || age_ms >= READABLE_MS) {
    store.setState({ last: said, waiting: null, isRefusal: false });
    return;
  }
  store.setState({ waiting: said });
  if (waiting === null) {
    timers.after(READABLE_MS - age_ms, () =>
      store.setState((now) =>
        now.waiting === null || now.last !== last
          ? now
          : { last: now.waiting, waiting: null, isRefusal: false },
      ),
    );
  }
}

function keep(store: MessageStore, message: Message, said_ms: number): SaidMessage {
  const { kept } = store.getState();
  const said = { ...message, number: (kept.at(-1)?.number ?? 0) + 1, said_ms };
  store.setState({ kept: [...kept, said].slice(-MOST_KEPT) });
  return said;
}

const LEVELS: readonly unknown[] = ["info", "warning", "error"] satisfies MessageLevel[];

function isSaid(value: unknown): value is SaidMessage {
  return (
    isObject(value) &&
    LEVELS.includes(value["level"]) &&
    isText(value["key"]) &&
    isObject(value["params"]) &&
    Object.values(value["params"]).every((one) => isText(one) || isNumber(one)) &&
    (value["fallback"] === undefined || isText(value["fallback"])) &&
    isNumber(value["number"]) &&
    isNumber(value["said_ms"])
  );
}

function read(storage: BrowserStorage | null): readonly SaidMessage[] {
  try {
    const stored: unknown = JSON.parse(storage?.getItem(KEY) ?? "[]");
    return Array.isArray(stored) ? stored.filter(isSaid).slice(-MOST_KEPT) : [];
  } catch {
    return [];
  }
}

function write(storage: BrowserStorage | null, kept: readonly SaidMessage[]): void {
  try {
    storage?.setItem(KEY, JSON.stringify(kept));
  } catch {
    // Full or forbidden: the messages last as long as the page.
  }
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
