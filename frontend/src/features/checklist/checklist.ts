import { createStore, type StoreApi } from "zustand/vanilla";
import { isObject } from "../../lib/check";
import type { StreamEvent } from "../../protocol/envelope";
import { type ChecklistLine, isChecklist } from "../../protocol/guards.gen";
import type { Gateway } from "../../requests/asking";
import { failureMessage, type Message } from "../../store/messages";
import { partName } from "../../store/parts";
import type { BrowserStorage } from "../../store/settings";

export type AutomaticCheck = NonNullable<ChecklistLine["watched"]>;
export const WATCHED = [
  "gps",
  "battery",
  "gains",
  "plan",
  "recorder",
  "alarms",
] as const satisfies readonly AutomaticCheck[];

/** The page's own list: these, then what the station sees. Their texts are in the catalogue. */
export const OWN_LINES = ["airframe", "balance", "surfaces", "transmitter", "wind"] as const;

export interface ChecklistState {
  /** Null until read; `isOwn`: nobody changed the list, so it is the page's. */
  readonly list: { readonly isOwn: boolean; readonly lines: readonly ChecklistLine[] } | null;
  readonly failure: Message | null;
  /** Lines that a person ticked, by their id. */
  readonly ticked: readonly string[];
  /** Grows with each change of the list that came from the station. */
  readonly version: number;
}

export interface ChecklistPart {
  readonly store: StoreApi<ChecklistState>;
  /** Whether the page sees now what a line says. */
  readonly sees: (watched: AutomaticCheck) => boolean;
  readonly read: () => Promise<void>;
  /** Keep the lines for everybody; null: the page's own list again. Returns the message of a failure. */
  readonly keep: (lines: readonly ChecklistLine[] | null) => Promise<Message | null>;
  readonly tick: (id: string, isDone: boolean) => void;
  readonly again: () => void;
}

export const CHECKLIST = partName<ChecklistPart>("checklist");
const PATH = "/api/v1/checklist";
const KEY = "epf-gcs.checklist";

export function createChecklist(parts: {
  readonly rest: Pick<Gateway, "ask">;
  readonly storage: BrowserStorage | null;
  readonly sees: (watched: AutomaticCheck) => boolean;
}): { readonly checklist: ChecklistPart; readonly takeChecklistEvent: (event: StreamEvent) => void } {
  const { rest, storage, sees } = parts;
  const store = createStore<ChecklistState>(() => ({
    list: null,
    failure: null,
    ticked: stored(storage),
    version: 0,
  }));

  function settle(answer: Awaited<ReturnType<typeof ask>>): Message | null {
    if (!answer.ok) {
      const failure = failureMessage(answer.problem);
      store.setState({ failure });
      return failure;
    }
    const { lines } = answer.value;
    store.setState({ list: { isOwn: lines === null, lines: lines ?? [] }, failure: null });
    return null;
  }

  function ask(method: "GET" | "PUT" | "DELETE", body?: object) {
    return rest.ask(method, PATH, isChecklist, body);
  }

  function setTicked(ticked: readonly string[]): void {
    store.setState({ ticked });
    try {
      storage?.setItem(KEY, JSON.stringify({ ticked }));
    } catch {
      // Full or forbidden: the ticks last as long as the page.
    }
  }

  const checklist: ChecklistPart = {
    store,
    sees,
    read: async () => void settle(await ask("GET")),
    keep: async (lines) => settle(await (lines === null ? ask("DELETE") : ask("PUT", { lines }))),
    tick: (id, isDone) => {
      const others = store.getState().ticked.filter((one) => one !== id);
      setTicked(isDone ? [...others, id] : others);
    },
    again: () => setTicked([]),
  };
  return {
    checklist,
    takeChecklistEvent: ({ event }) => {
      if (event === "checklist") {
        store.setState(({ version }) => ({ version: version + 1 }));
        if (store.getState().list !== null) {
          void checklist.read();
        }
      }
    },
  };
}

function stored(storage: BrowserStorage | null): readonly string[] {
  try {
    const value: unknown = JSON.parse(storage?.getItem(KEY) ?? "null");
    const ticked = isObject(value) ? value["ticked"] : null;
    return Array.isArray(ticked) ? ticked.filter((one) => typeof one === "string") : [];
  } catch {
    return [];
  }
}
