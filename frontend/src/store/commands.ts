import { createStore, type StoreApi } from "zustand/vanilla";
import type { Message } from "./messages";

/** Outcome of a command. `sent`: it was sent, and this board gives no proof. */
export type Outcome = "confirmed" | "rejected" | "timed_out" | "sent";
export type CommandState = "idle" | "pending" | Outcome;

/** A command under way or just finished. `asked` is the requested position, in its control's terms. */
export interface CommandEntry {
  readonly state: Exclude<CommandState, "idle">;
  readonly asked: string | null;
  /** When the outcome is no longer shown, milliseconds of the page's clock; a pending one stays. */
  readonly until_ms: number;
  readonly message: Message | null;
}

/** Entries by control: two buttons of one switch share a key, so that the newest click is shown. */
export interface Commands {
  readonly entries: Readonly<Record<string, CommandEntry>>;
}

export type CommandStore = StoreApi<Commands>;

const SHOW_GOOD_MS = 3000;
/** A failure is shown longer, so that the reason can be read. */
const SHOW_BAD_MS = 10_000;

export function createCommands(): CommandStore {
  return createStore<Commands>(() => ({ entries: {} }));
}

export function begin(store: CommandStore, key: string, asked: string | null): CommandEntry {
  const entry: CommandEntry = { state: "pending", asked, until_ms: Number.POSITIVE_INFINITY, message: null };
  put(store, key, entry);
  return entry;
}

/** Finish the command that `begin` returned; a newer one of the same control keeps its state. */
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

/** The entry to show at this time, or null. */
export function shown(commands: Commands, key: string, now_ms: number): CommandEntry | null {
  const entry = commands.entries[key];
  return entry !== undefined && now_ms < entry.until_ms ? entry : null;
}

function put(store: CommandStore, key: string, entry: CommandEntry): void {
  store.setState(({ entries }) => ({ entries: { ...entries, [key]: entry } }));
}
