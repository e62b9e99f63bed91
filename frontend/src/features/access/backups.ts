import type { StoreApi } from "zustand/vanilla";
import { createStore } from "zustand/vanilla";
import { Polling } from "../../lib/repeating";
import type { Timers } from "../../lib/timers";
import { isJob, isJobList, isJobStart, type Job } from "../../protocol/guards.gen";
import { type Asker, createAsking, info, type RequesterParts } from "../../requests/asking";
import { failureMessage, type Message } from "../../store/messages";
import { partName } from "../../store/parts";

export interface BackupState {
  /** The newest backup, also one that another owner began; null if the station keeps none. */
  readonly job: Job | null;
  /** Why it could not be read; it is as it was. */
  readonly failure: Message | null;
}

/** Backups of the station, for its owners. */
export interface Backups {
  readonly store: StoreApi<BackupState>;
  /** Read the newest backup now, and every second while it is made, until the returned function is called. */
  readonly watch: () => () => void;
  /** `onBegun` is called if the station took the password. */
  readonly make: (password: string, asker: Asker, onBegun: () => void) => Promise<void>;
  readonly cancel: (job: string, asker: Asker) => Promise<void>;
}

export const BACKUPS = partName<Backups>("backups");

const EVERY_MS = 1000;
/** Characters, as the station takes them. */
export const SHORTEST_PASSWORD = 10;
export const LONGEST_PASSWORD = 200;

export type PasswordFault = "short" | "long" | "unprintable" | "differs";

/** What is wrong with a password that was typed twice; null: the station takes it. */
export function passwordFault(password: string, again: string): PasswordFault | null {
  const length = [...password].length;
  if (length < SHORTEST_PASSWORD) return "short";
  if (length > LONGEST_PASSWORD) return "long";
  if (!/^(?:[^\p{C}\p{Z}]| )*$/u.test(password)) return "unprintable";
  return password === again ? null : "differs";
}

export function isUnderWay({ state }: Job): boolean {
  return state === "waiting" || state === "running";
}

export function createBackups(parts: RequesterParts & { readonly timers: Timers }): Backups {
  const { rest, timers } = parts;
  const { run } = createAsking(parts);
  const store = createStore<BackupState>(() => ({ job: null, failure: null }));

  /** False: nothing changes before somebody begins another one. */
  async function read(): Promise<boolean> {
    const answer = await rest.ask("GET", "/api/v1/jobs", isJobList);
    if (!answer.ok) {
      store.setState({ failure: failureMessage(answer.problem) });
      return true;
    }
    const job = answer.value.jobs.find(({ kind }) => kind === "backup") ?? null;
    store.setState({ job, failure: null });
    return job !== null && isUnderWay(job);
  }

  const polling = new Polling(timers, EVERY_MS, read);

  return {
    store,
    watch: polling.watch,
    make: (password, asker, onBegun) =>
      run(asker, rest.ask("POST", "/api/v1/backups", isJobStart, { password }), () => {
        onBegun();
        polling.read();
        return { state: "confirmed", message: info("backup.saidBegun") };
      }),
    cancel: (job, asker) =>
      run(asker, rest.ask("DELETE", `/api/v1/jobs/${job}`, isJob), () => {
        polling.read();
        return { state: "confirmed", message: info("backup.saidCancelled") };
      }),
  };
}
