import { createStore, type StoreApi } from "zustand/vanilla";

/** What a person or program may do here, the least first; each may also do what those before it may. */
export const ROLES = ["viewer", "operator", "owner"] as const;
export type Role = (typeof ROLES)[number];

/** Who the station takes this page's user for. */
export interface Admission {
  /** `unknown`: not asked yet, or the station does not answer. `waiting`: asked to be let in. */
  readonly state: "unknown" | "stranger" | "waiting" | "in";
  /** `local`: the station's own computer, which needs no key. */
  readonly kind: "local" | "person" | "program" | "anyone" | null;
  /** Null while not known: then nothing is disabled because of it. */
  readonly role: Role | null;
  readonly name: string | null;
  /** The station was started so that anyone on the network may fly without a key. */
  readonly anyoneMayFly: boolean;
}

export type AdmissionStore = StoreApi<Admission>;

export const NOT_HEARD: Admission = {
  state: "unknown",
  kind: null,
  role: null,
  name: null,
  anyoneMayFly: false,
};

export function createAdmission(): AdmissionStore {
  return createStore<Admission>(() => NOT_HEARD);
}

export function isAtLeast(role: Role, least: Role): boolean {
  return ROLES.indexOf(role) >= ROLES.indexOf(least);
}
