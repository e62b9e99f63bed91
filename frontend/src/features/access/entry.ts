import { createStore, type StoreApi } from "zustand/vanilla";
import { isNumber } from "../../lib/check";
import { Repeating } from "../../lib/repeating";
import type { Timers } from "../../lib/timers";
import type { Problem } from "../../protocol/answers";
import { isMe, type Me } from "../../protocol/guards.gen";
import type { Gateway } from "../../requests/asking";
import { type Admission, type AdmissionStore, NOT_HEARD } from "../../store/admission";
import { failureMessage, type Message } from "../../store/messages";
import { partName } from "../../store/parts";

/** What the entry page shows besides who the station takes the user for. */
export interface EntryState {
  /** The key that came with the address, until it is used or refused. */
  readonly key: string | null;
  readonly isAsking: boolean;
  /** Why the last try failed, or why the user is no longer in. */
  readonly message: Message | null;
  /** The page's clock from which on another try is taken; null: at once. */
  readonly retry_ms: number | null;
}

export interface Who {
  readonly name: string;
  readonly place: string;
}

/** The way in: with a key, or by asking the owner. */
export interface Entry {
  readonly store: StoreApi<EntryState>;
  readonly enter: (key: string, who: Who) => Promise<void>;
  /** Ask to be let in, and wait for the owner. */
  readonly ask: (who: Who) => Promise<void>;
  /** End one's own session, or stop waiting. */
  readonly leave: () => Promise<void>;
  readonly now_ms: () => number;
  readonly after: Timers["after"];
  /** The page came by https: a browser that did not trust the station has warned of it. */
  readonly isEncrypted: boolean;
}

export const ENTRY = partName<Entry>("entry");

interface EntryParts {
  readonly rest: Gateway;
  readonly timers: Timers;
  readonly admission: AdmissionStore;
  /** The key that the page's address carried. */
  readonly addressedKey: string | null;
  readonly isEncrypted: boolean;
  /** Admitted: the stream may be dialled. Called again without a stop between is harmless. */
  readonly start: () => void;
  /** Not admitted, or no longer: nothing of the vehicle is shown or asked any more. */
  readonly stop: () => void;
}

export interface EntryProcess {
  readonly entry: Entry;
  readonly begin: () => void;
  /** The stream was greeted by the station, or it broke: ask who the user is for it now. */
  readonly review: () => void;
}

/** While somebody waits to be let in, the station is asked so often. */
const WAITING_MS = 1500;
const ME = "/api/v1/access/me";

/**
 * Finds out whether the station admits this page. The stream is dialled at the same time: on the station's own computer
 * nobody waits for the answer. Only a page that was opened with a key asks first.
 */
export function createEntry(parts: EntryParts): EntryProcess {
  const { rest, timers, admission, addressedKey, isEncrypted, start, stop } = parts;
  const store = createStore<EntryState>(() => ({
    key: addressedKey,
    isAsking: false,
    message: null,
    retry_ms: null,
  }));
  const asks = new Repeating(
    timers,
    async () => {
      await ask();
      return null;
    },
    WAITING_MS,
  );
  let asked = 0;
  // Let in, and not yet known by the cookie that came with it.
  let isUnproven = false;

  async function ask(): Promise<void> {
    asked += 1;
    const mine = asked;
    const answer = await rest.ask("GET", ME, isMe);
    if (mine !== asked) {
      return;
    }
    if (answer.ok) {
      take(answer.value);
      isUnproven = false;
    } else if (admission.getState().state === "unknown") {
      // A station that does not answer is dialled until it does, and asked again then.
      start();
    } else if (admission.getState().state === "waiting") {
      asks.arm(WAITING_MS);
    }
  }

  function take(me: Me): void {
    const before = admission.getState();
    admission.setState(admissionOf(me));
    asks.cancel();
    if (me.state === "waiting") {
      asks.arm(WAITING_MS);
    }
    if (me.state === "in") {
      store.setState({ key: null, message: null, retry_ms: null });
      start();
      return;
    }
    stop();
    if (isUnproven && me.state === "stranger") {
      store.setState({ message: { level: "error", key: "access.cookieNotKept", params: {} } });
    } else if (before.state === "in") {
      store.setState({ message: { level: "warning", key: "access.ended", params: {} } });
    } else if (before.state === "waiting" && me.state === "stranger") {
      store.setState({ message: { level: "warning", key: "access.notLetIn", params: {} } });
    }
  }

  async function tryTo(path: string, body: object, failed: (problem: Problem) => void): Promise<void> {
    store.setState({ isAsking: true, message: null });
    const answer = await rest.ask("POST", path, isMe, body);
    store.setState({ isAsking: false });
    asked += 1;
    if (answer.ok) {
      take(answer.value);
      isUnproven = answer.value.state === "in";
    } else {
      failed(answer.problem);
    }
  }

  function refused(problem: Problem): void {
    const seconds = problem.params["retry_after_s"];
    store.setState({
      message: failureMessage(problem),
      retry_ms: isNumber(seconds) ? timers.now_ms() + seconds * 1000 : null,
    });
  }

  const entry: Entry = {
    store,
    enter: (key, who) =>
      tryTo("/api/v1/access/enter", { key, ...who }, (problem) => {
        refused(problem);
        // A wrong key is corrected by hand; one that was only too early is tried again as it is.
        if (problem.params["retry_after_s"] === undefined && problem.code !== "gateway_unreachable") {
          store.setState({ key: null });
        }
      }),
    ask: (who) => tryTo("/api/v1/access/ask", who, refused),
    leave: async () => {
      const answer = await rest.ask("POST", "/api/v1/access/leave", isMe);
      asked += 1;
      if (answer.ok) {
        take(answer.value);
        store.setState({ message: null });
      } else {
        refused(answer.problem);
      }
    },
    now_ms: timers.now_ms,
    after: timers.after,
    isEncrypted,
  };

  return {
    entry,
    begin: () => {
      if (addressedKey === null) {
        start();
      }
      asks.run();
    },
    review: () => asks.run(),
  };
}

function admissionOf(me: Me): Admission {
  return me.state === "in"
    ? { state: "in", kind: me.kind, role: me.role, name: me.name, anyoneMayFly: me.anyone_may_fly }
    : { ...NOT_HEARD, state: me.state };
}
