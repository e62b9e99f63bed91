import { useStore } from "zustand";
import { createStore, type StoreApi } from "zustand/vanilla";
import type { Journal, JournalEntry, ParameterMoves } from "../../protocol/contract";
import type { GainState, OwnGains, OwnGainsEvent } from "../../protocol/guards.gen";
import { PARAMETERS, type ParameterName } from "../../protocol/messages.gen";
import { isParameterName } from "../../protocol/parameterName";
import type { Asker } from "../../requests/asking";
import { usePart } from "../../store/hooks";
import type { Message } from "../../store/messages";
import { partName } from "../../store/parts";

/** Requested values by parameter name. */
export type Changes = Readonly<Partial<Record<string, number>>>;

/** The 17 gains and the board's own as the gateway knows them, and the journal of what was written to them. */
export interface ParameterValues {
  readonly held: Readonly<Record<ParameterName, GainState>>;
  readonly own: OwnGains;
  /** Null until read from the gateway. */
  readonly journal: Journal | null;
  /** When the board confirmed that these values are on its card, Unix milliseconds; null: unknown. */
  readonly stored_ms: number | null;
}

/** A gain with what it may be: one of the 17, or one that the board describes itself. */
export interface GainInfo {
  readonly name: string;
  readonly minimum: number;
  readonly maximum: number;
  readonly default: number;
  readonly isInteger: boolean;
}

/** All gains that the board is known to have. */
export function gainsOf({ own: { table } }: ParameterValues): readonly GainInfo[] {
  const own = table.state === "known" ? table.gains : [];
  return [...PARAMETERS, ...own.map((gain) => ({ ...gain, isInteger: gain.type !== "f32" }))];
}

/** What is known of a gain. */
export function stateOf({ held, own }: ParameterValues, name: string): GainState {
  return (isParameterName(name) ? held[name] : own.values[name]) ?? UNKNOWN;
}

export type ParameterStore = StoreApi<ParameterValues>;

/** The user's requests about the gains; nothing here throws. */
export interface ParameterActions {
  readonly values: ParameterStore;
  /** Read what the gateway knows; nothing is asked of the board. */
  readonly refresh: () => Promise<void>;
  readonly load: (asker: Asker) => Promise<void>;
  /** Write one; while its last write is under way, only the newest request waits. */
  readonly edit: (name: string, value: number) => Promise<void>;
  /**
   * Write several in one step, and read them back. Returns the message of a failure, or null: then `held` has each
   * outcome.
   */
  readonly write: (changes: Changes, asker: Asker) => Promise<Message | null>;
  readonly undo: (asker: Asker) => Promise<void>;
  readonly redo: (asker: Asker) => Promise<void>;
  readonly store: (asker: Asker) => Promise<void>;
}

export const PARAMETER_REQUESTS = partName<ParameterActions>("parameters");

const UNKNOWN: GainState = { value: null, loaded: null, state: "unknown" };
const NOTHING: ParameterValues = {
  held: fill(() => UNKNOWN),
  own: {
    table: { state: "none", blocks_read: 0, block_count: 0, gains: [], topics: [], left_out: [] },
    values: {},
  },
  journal: null,
  stored_ms: null,
};

export function createParameters(): ParameterStore {
  return createStore<ParameterValues>(() => NOTHING);
}

/** Forget everything: the gateway is lost. */
export function forget(store: ParameterStore): void {
  store.setState(NOTHING);
}

/** Take the gateway's report of some gains. When a value changes, the card no longer has what the board has. */
export function take(store: ParameterStore, news: Readonly<Partial<Record<ParameterName, GainState>>>): void {
  store.setState(({ held, stored_ms }) => {
    const next = fill((name) => news[name] ?? held[name]);
    const isSame = PARAMETERS.every(({ name }) => next[name].value === held[name].value);
    return { held: next, stored_ms: isSame ? stored_ms : null };
  });
}

/**
 * Take the gateway's report of the board's own gains: with a table come all of its values. When a value changes, the
 * card no longer has what the board has.
 */
export function takeOwn(store: ParameterStore, { table, values }: OwnGains | OwnGainsEvent): void {
  store.setState(({ own, stored_ms }) => {
    const isSame = Object.entries(values).every(([name, { value }]) => value === own.values[name]?.value);
    return {
      own: table === null ? { ...own, values: { ...own.values, ...values } } : { table, values },
      stored_ms: isSame ? stored_ms : null,
    };
  });
}

export function takeJournal(store: ParameterStore, journal: Journal): void {
  store.setState({ journal });
}

/** The page keeps as many entries as the gateway. */
const KEPT = 1000;

/** Add an entry, and what can be undone after it. Nothing is kept before the whole journal was read. */
export function takeEntry(
  store: ParameterStore,
  news: {
    readonly entry: JournalEntry | null;
    readonly undo: ParameterMoves;
    readonly redo: ParameterMoves;
  },
): void {
  store.setState(({ journal }) => {
    if (journal === null) {
      return {};
    }
    const { entry, undo, redo } = news;
    const entries = entry === null ? journal.entries : [entry, ...journal.entries].slice(0, KEPT);
    return { journal: { entries, undo, redo } };
  });
}

export function takeStored(store: ParameterStore, at_ms: number): void {
  store.setState({ stored_ms: at_ms });
}

function fill(of: (name: ParameterName) => GainState): ParameterValues["held"] {
  return Object.fromEntries(PARAMETERS.map(({ name }) => [name, of(name)])) as ParameterValues["held"];
}

export function useParameters<T>(select: (values: ParameterValues) => T): T {
  return useStore(usePart(PARAMETER_REQUESTS).values, select);
}
