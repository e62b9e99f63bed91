import { createStore, type StoreApi } from "zustand/vanilla";
import type { Check } from "../../lib/check";
import { Polling } from "../../lib/repeating";
import type { Timers } from "../../lib/timers";
import {
  type Addresses,
  type Certificates,
  type Deeds,
  type InvitationState,
  isAddresses,
  isCertificates,
  isDeeds,
  isInvitationList,
  isNewInvitation,
  isNewProgram,
  isPeople,
  isPersonState,
  isProgramList,
  isSessionList,
  type NewInvitation,
  type NewProgram,
  type PersonState,
  type ProgramState,
  type SessionState,
} from "../../protocol/guards.gen";
import { type Asker, createAsking, info, type RequesterParts } from "../../requests/asking";
import type { Role } from "../../store/admission";
import { failureMessage, type Message } from "../../store/messages";
import { partName } from "../../store/parts";

/** Who may come in, as the station said last; null: not heard yet. */
export interface AccessLists {
  readonly people: readonly PersonState[] | null;
  readonly sessions: readonly SessionState[];
  readonly programs: readonly ProgramState[] | null;
  readonly invitations: readonly InvitationState[] | null;
  readonly addresses: Addresses | null;
  readonly certificates: Certificates | null;
  /** Why the lists could not be read; they are as they were. */
  readonly failure: Message | null;
  /** The key made last, until it is put away: it is shown once. */
  readonly made: { readonly invitation: NewInvitation } | { readonly program: NewProgram } | null;
}

export interface PersonChange {
  readonly role?: Role;
  readonly name?: string;
  readonly state?: "in" | "ended";
}

export interface InvitationWish {
  readonly role: Role;
  readonly minutes: number;
  readonly address?: string;
  readonly tab?: string;
}

/** What an owner decides about who may come in. */
export interface AccessAdmin {
  readonly store: StoreApi<AccessLists>;
  /** Read the lists now and every few seconds, until the returned function is called. */
  readonly watch: () => () => void;
  readonly changePerson: (id: string, change: PersonChange, asker: Asker) => Promise<void>;
  readonly forgetPerson: (id: string, asker: Asker) => Promise<void>;
  readonly endSession: (id: string, asker: Asker) => Promise<void>;
  readonly makeProgram: (name: string, role: Role, asker: Asker) => Promise<void>;
  readonly endProgram: (id: string, asker: Asker) => Promise<void>;
  readonly invite: (wish: InvitationWish, asker: Asker) => Promise<void>;
  readonly endInvitation: (id: string, asker: Asker) => Promise<void>;
  readonly putAway: () => void;
  /** The newest deeds that have this text in them, or those before the one that stands at `before`. */
  readonly readLog: (text: string, before: number | null) => Promise<Deeds | Message>;
  /** The address line of this page, for the address of a tab without a key. */
  readonly address: () => string;
}

export const ACCESS_ADMIN = partName<AccessAdmin>("access admin");

interface AdminParts extends RequesterParts {
  readonly timers: Timers;
  readonly address: () => string;
}

const EVERY_MS = 3000;
const ROOT = "/api/v1/access";
/** Lines of the log that are read at once. */
export const LOG_LINES = 100;

export function createAccessAdmin(parts: AdminParts): AccessAdmin {
  const { rest, timers } = parts;
  const { run, simply } = createAsking(parts);
  const store = createStore<AccessLists>(() => ({
    people: null,
    sessions: [],
    programs: null,
    invitations: null,
    addresses: null,
    certificates: null,
    failure: null,
    made: null,
  }));

  async function read<T>(
    path: string,
    check: Check<T>,
    take: (value: T) => Partial<AccessLists>,
  ): Promise<void> {
    const answer = await rest.ask("GET", `${ROOT}/${path}`, check);
    store.setState(answer.ok ? take(answer.value) : { failure: failureMessage(answer.problem) });
  }

  async function readLists(): Promise<void> {
    store.setState({ failure: null });
    await Promise.all([
      read("people", isPeople, ({ people }) => ({ people })),
      read("sessions", isSessionList, ({ sessions }) => ({ sessions })),
      read("programs", isProgramList, ({ programs }) => ({ programs })),
      read("invitations", isInvitationList, ({ invitations }) => ({ invitations })),
    ]);
  }

  async function change(asked: Promise<void>): Promise<void> {
    await asked;
    await readLists();
  }

  function nameOf(list: "people" | "programs", id: string): string {
    return store.getState()[list]?.find((one) => one.id === id)?.name ?? "";
  }

  const polling = new Polling(timers, EVERY_MS, readLists);

  function watch(): () => void {
    const end = polling.watch();
    void read("addresses", isAddresses, (addresses) => ({ addresses }));
    void read("certificates", isCertificates, (certificates) => ({ certificates }));
    return end;
  }

  return {
    store,
    watch,
    address: parts.address,
    changePerson: (id, body, asker) =>
      change(
        run(asker, rest.ask("PATCH", `${ROOT}/people/${id}`, isPersonState, body), () => ({
          state: "confirmed",
          message: info(body.state === "ended" ? "access.removed" : "access.changed", {
            name: nameOf("people", id),
          }),
        })),
      ),
    forgetPerson: (id, asker) =>
      change(
        simply(
          asker,
          ["DELETE", `${ROOT}/people/${id}`],
          info("access.removed", { name: nameOf("people", id) }),
        ),
      ),
    endSession: (id, asker) =>
      change(simply(asker, ["DELETE", `${ROOT}/sessions/${id}`], info("access.sessionEnded"))),
    makeProgram: (name, role, asker) =>
      change(
        run(asker, rest.ask("POST", `${ROOT}/programs`, isNewProgram, { name, role }), (program) => {
          store.setState({ made: { program } });
          return { state: "confirmed", message: info("access.made") };
        }),
      ),
    endProgram: (id, asker) =>
      change(
        simply(
          asker,
          ["DELETE", `${ROOT}/programs/${id}`],
          info("access.removed", { name: nameOf("programs", id) }),
        ),
      ),
    invite: (wish, asker) =>
      change(
        run(asker, rest.ask("POST", `${ROOT}/invitations`, isNewInvitation, wish), (invitation) => {
          store.setState({ made: { invitation } });
          return { state: "confirmed", message: info("access.made") };
        }),
      ),
    endInvitation: (id, asker) =>
      change(simply(asker, ["DELETE", `${ROOT}/invitations/${id}`], info("access.invitationEnded"))),
    putAway: () => store.setState({ made: null }),
    readLog: async (text, before) => {
      const query = new URLSearchParams({ limit: String(LOG_LINES), text });
      if (before !== null) {
        query.set("before", String(before));
      }
      const answer = await rest.ask("GET", `${ROOT}/log?${query}`, isDeeds);
      return answer.ok ? answer.value : failureMessage(answer.problem);
    },
  };
}
