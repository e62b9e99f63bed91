import { createStore, type StoreApi } from "zustand/vanilla";
import { type DoctorFinding, isDoctorReport } from "../../protocol/guards.gen";
import type { Gateway } from "../../requests/asking";
import { failureMessage, type Message } from "../../store/messages";
import { partName } from "../../store/parts";
import type { Language } from "../../store/settings";

export interface DoctorState {
  /** What was found at the last look that succeeded; null before it. */
  readonly findings: readonly DoctorFinding[] | null;
  /** Of the newest look, whatever became of it; null before the first. */
  readonly language: Language | null;
  /** Why the newest look failed. */
  readonly failure: Message | null;
  readonly isLooking: boolean;
}

/** What on the station's computer keeps it from working. */
export interface Doctor {
  readonly store: StoreApi<DoctorState>;
  /** Have the station look, in this language; nothing happens while it is looking. */
  readonly look: (language: Language) => Promise<void>;
}

export const DOCTOR = partName<Doctor>("doctor");

/** The station gives up after a minute. */
const PATIENCE_MS = 70_000;

export function createDoctor({ rest }: { readonly rest: Gateway }): Doctor {
  const store = createStore<DoctorState>(() => ({
    findings: null,
    language: null,
    failure: null,
    isLooking: false,
  }));
  return {
    store,
    look: async (language) => {
      if (store.getState().isLooking) {
        return;
      }
      store.setState({ isLooking: true, language });
      const path = `/api/v1/doctor?lang=${language}`;
      const answer = await rest.ask("GET", path, isDoctorReport, undefined, PATIENCE_MS);
      store.setState(
        answer.ok
          ? { isLooking: false, findings: answer.value.findings, failure: null }
          : { isLooking: false, failure: failureMessage(answer.problem) },
      );
    },
  };
}
