import { useSyncExternalStore } from "react";
import { createStore, type StoreApi } from "zustand/vanilla";
import { usePage, usePart } from "../../store/hooks";
import type { Message } from "../../store/messages";
import { partName } from "../../store/parts";

export interface ConsoleEntry {
  readonly number: number;
  readonly direction: "sent" | "received";
  readonly text: string;
  /** Unix milliseconds, this browser's clock. */
  readonly at_ms: number;
}

export interface ConsoleLog {
  /** Oldest first. */
  readonly entries: readonly ConsoleEntry[];
  /** Number of old lines dropped since the list was cleared. */
  readonly dropped: number;
}

export type ConsoleStore = StoreApi<ConsoleLog>;

/** The raw line to the board and what came back. */
export interface BoardConsole {
  readonly store: ConsoleStore;
  /** Send a line; null if it was sent, else why not. */
  readonly send: (text: string) => Promise<Message | null>;
  readonly clear: () => void;
}

export const BOARD_CONSOLE = partName<BoardConsole>("board console");

/** Bounded: a board may send text without end. */
export const CONSOLE_LINES = 200;

export function createConsole(): ConsoleStore {
  return createStore<ConsoleLog>(() => ({ entries: [], dropped: 0 }));
}

export function note(store: ConsoleStore, entry: Omit<ConsoleEntry, "number">): void {
  store.setState(({ entries, dropped }) => {
    const number = (entries.at(-1)?.number ?? dropped) + 1;
    const all = [...entries, { ...entry, number }];
    const over = Math.max(0, all.length - CONSOLE_LINES);
    return { entries: all.slice(over), dropped: dropped + over };
  });
}

export function clearConsole(store: ConsoleStore): void {
  store.setState({ entries: [], dropped: 0 });
}

/** The raw line's log, read ten times a second: a fast board must not render for each line. */
export function useConsole(): ConsoleLog {
  const { pump } = usePage();
  const boardConsole = usePart(BOARD_CONSOLE);
  return useSyncExternalStore(pump.onTick, () => boardConsole.store.getState());
}
