import { createStore, type StoreApi } from "zustand/vanilla";
import { Polling } from "../../lib/repeating";
import type { Timers } from "../../lib/timers";
import { type ControlDetails, isControlDetails } from "../../protocol/guards.gen";
import type { Gateway } from "../../requests/asking";
import { partName } from "../../store/parts";

type Pages = ControlDetails["pages"];

/** All pages on the live stream, to hand control over to. */
export interface ControlPages {
  readonly store: StoreApi<{ readonly pages: Pages }>;
  /** Read them now and every few seconds, until the returned function is called. */
  readonly watch: () => () => void;
}

export const CONTROL_PAGES = partName<ControlPages>("control pages");

const EVERY_MS = 2000;

export function createControlPages(rest: Gateway, timers: Timers): ControlPages {
  const store = createStore<{ readonly pages: Pages }>(() => ({ pages: [] }));
  const polling = new Polling(timers, EVERY_MS, async () => {
    const answer = await rest.ask("GET", "/api/v1/control", isControlDetails);
    store.setState({ pages: answer.ok ? answer.value.pages : [] });
  });
  return { store, watch: polling.watch };
}
