import { createStore, type StoreApi } from "zustand/vanilla";
import { isDone } from "../../protocol/answers";
import { isFirstStartState } from "../../protocol/guards.gen";
import type { Gateway } from "../../requests/asking";
import type { AdmissionStore } from "../../store/admission";
import type { ConnectionStore } from "../../store/connection";
import { failureMessage, type Message } from "../../store/messages";
import { partName } from "../../store/parts";
import type { SettingsStore } from "../../store/settings";

/** The page of a station that nobody has set up. */
export interface FirstStart {
  readonly store: StoreApi<{ readonly isShown: boolean }>;
  /** Done, or put off: it goes at once, and the station does not ask for it again. */
  readonly end: () => Promise<void>;
}

export const FIRST_START = partName<FirstStart>("first start");

interface Parts {
  readonly rest: Gateway;
  readonly admission: AdmissionStore;
  readonly connection: ConnectionStore;
  readonly settings: SettingsStore;
  readonly tell: (message: Message) => void;
}

const PATH = "/api/v1/first-start";

/** `begin` asks the station once, when it is known that an owner looks at a station whose board is closed. */
export function createFirstStart({ rest, admission, connection, settings, tell }: Parts): {
  readonly firstStart: FirstStart;
  readonly begin: () => void;
} {
  const store = createStore(() => ({ isShown: false }));
  let isJudged = false;

  function judge(): void {
    const { status } = connection.getState();
    if (isJudged || status === null || admission.getState().role !== "owner") {
      return;
    }
    isJudged = true;
    if (status.board.state === "closed") {
      void ask();
    }
  }

  async function ask(): Promise<void> {
    const answer = await rest.ask("GET", PATH, isFirstStartState);
    // A station that does not answer is no new one.
    store.setState({ isShown: answer.ok && answer.value.is_due });
  }

  return {
    firstStart: {
      store,
      end: async () => {
        store.setState({ isShown: false });
        const answer = await rest.ask("DELETE", PATH, isDone);
        if (!answer.ok) {
          tell(failureMessage(answer.problem));
        }
      },
    },
    begin: () => {
      admission.subscribe(judge);
      connection.subscribe(judge);
      // Who chooses a tab wants to see it; the next load asks again.
      settings.subscribe(({ choices }, before) => {
        if (choices["tab"] !== before.choices["tab"]) {
          store.setState({ isShown: false });
        }
      });
    },
  };
}
