import { createStore, type StoreApi } from "zustand/vanilla";
import type { Message } from "./messages";

/** What became of a command. `sent`: it went out, and this board gives no proof of it. */
export type Outcome = "confirmed" | "rejected" | "timed_out" | "sent";
export type CommandState = "idle" | "pending" | Outcome;

/** One command under way or just over. `asked` is what it shall bring about, in the words of its control. */
export interface CommandEntry {
  readonly state: Exclude<CommandState, "idle">;
  readonly asked: string | null;
  /** Milliseconds of the page's clock until which the outcome is shown; a pending one stays. */
  readonly until_ms: number;
  readonly message: Message | null;
}

/** Entries by control: two buttons of one switch share a key, so that the newest press is what is shown. */
export interface Commands {
  readonly entries: Readonly<Record<string, CommandEntry>>;
}

export type CommandStore = StoreApi<Commands>;

const SHOW_GOOD_MS = 3000;
/** A failure stays longer: somebody has to read why. */
const SHOW_BAD_MS = 10_000;

export function createCommands(): CommandStore {
  return createStore<Commands>(() => ({ entries: {} }));
}

export function begin(store: CommandStore, key: string, asked: string | null): CommandEntry {
  const entry: CommandEntry = { state: "pending", asked, until_ms: Number.POSITIVE_INFINITY, message: null };
  put(store, key, entry);
  return entry;
}

/** Finish what `begin` gave; a newer press of the same control keeps its own state. */
export function finish(
  store: CommandStore,
  key: string,
  begun: CommandEntry,
  outcome: { readonly state: Outcome; readonly message: Message | null },
  now_ms: number,
): void {
  if (store.getState().entries[key] === begun) {
    const good = outcome.state === "confirmed" || outcome.state === "sent";
    put(store, key, {
      ...outcome,
      asked: begun.asked,
      until_ms: now_ms + (good ? SHOW_GOOD_MS : SHOW_BAD_MS),
    });
  }
}

/** The entry as it is to be shown at this time, or null when there is nothing to show. */
export function shown(commands: Commands, key: string, now_ms: number): CommandEntry | null {
  const entry = commands.entries[key];
  return entry !== undefined && now_ms < entry.until_ms ? entry : null;
}

function put(store: CommandStore, key: string, entry: CommandEntry): void {
  store.setState(({ entries }) => ({ entries: { ...entries, [key]: entry } }));
}
