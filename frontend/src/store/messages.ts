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

/** `last` is what the status bar shows; `kept` is what was said in this browser tab, oldest first, over reloads too. */
export interface Messages {
  readonly last: SaidMessage | null;
  readonly kept: readonly SaidMessage[];
}

export interface MessageStore extends StoreApi<Messages> {
  /** The answer to what the user did: shown at once, and readable for `READABLE_MS`. */
  readonly say: (message: Message) => void;
  /**
   * What happened by itself. An information waits until an answer could be read, and the newest of those that wait is
   * shown then; a warning or an error is shown at once, because it may be of safety.
   */
  readonly announce: (message: Message) => void;
  /** Why a press did nothing. A drag on a greyed slider is many presses, and one answer. */
  readonly refuse: (reason: string) => void;
}

export interface MessageClocks {
  readonly timers: Timers;
  /** Unix milliseconds. */
  readonly wall_ms: () => number;
}

/** Some 100 kB in the tab's storage, and more than anybody reads. */
export const MOST_KEPT = 500;
/** How long an information that nobody asked for leaves an answer in the status bar. */
export const READABLE_MS = 5000;
const SAME_REFUSAL_MS = 1000;
const KEY = "epf-gcs.messages";

export function createMessages(
  { timers, wall_ms }: MessageClocks,
  storage: BrowserStorage | null = null,
): MessageStore {
  const store = createStore<Messages>(() => ({ last: null, kept: read(storage) }));
  let endReading: (() => void) | null = null;
  let waiting: SaidMessage | null = null;
  let refused_ms = 0;

  store.subscribe(({ kept: now }, { kept: before }) => {
    if (now !== before) {
      write(storage, now);
    }
  });

  function keep(message: Message): SaidMessage {
    const { kept } = store.getState();
    const said = { ...message, number: (kept.at(-1)?.number ?? 0) + 1, said_ms: wall_ms() };
    store.setState({ kept: [...kept, said].slice(-MOST_KEPT) });
    return said;
  }

  function show(last: SaidMessage): void {
    endReading?.();
    endReading = null;
    waiting = null;
    store.setState({ last });
  }

  function say(message: Message): void {
    show(keep(message));
    endReading = timers.after(READABLE_MS, () => {
      endReading = null;
      if (waiting !== null) {
        show(waiting);
      }
    });
  }

  return {
    ...store,
    say,
    announce: (message) => {
      const said = keep(message);
      if (message.level === "info" && endReading !== null) {
        waiting = said;
      } else {
        show(said);
      }
    },
    refuse: (reason) => {
      const { last } = store.getState();
      const isSaid = last?.key === "said.notDone" && last.params["reason"] === reason;
      if (isSaid && timers.now_ms() - refused_ms < SAME_REFUSAL_MS) {
        return;
      }
      refused_ms = timers.now_ms();
      say({ level: "warning", key: "said.notDone", params: { reason } });
    },
  };
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
