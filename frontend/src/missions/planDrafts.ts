import { createStore, type StoreApi } from "zustand/vanilla";
import { isNumber, isObject, list, shape } from "../lib/check";
import { amended, begun, edited, type History, redone, undone } from "../lib/history";
import { samePlan, type Waypoint } from "../lib/plan";
import type { CommandName } from "../protocol/messages.gen";
import { PLANS, type PlanFormat, type PlanName } from "../protocol/missions";
import type { Asker } from "../requests/asking";
import type { Message } from "../store/messages";
import { partName } from "../store/parts";
import type { BrowserStorage } from "../store/settings";

/** A flight plan: the draft, and the board's. */
export interface Plan {
  readonly draft: History<readonly Waypoint[]>;
  /** The board's plan, as read back; null if unknown. */
  readonly board: readonly Waypoint[] | null;
  /** The assumptions made when the draft was read from a file. */
  readonly notes: readonly Message[];
  /** A plan of the past: it is shown as it was, and no edit changes it. */
  readonly isFixed: boolean;
}

export type Plans = Readonly<Record<PlanName, Plan>>;
export type PlanStore = StoreApi<Plans>;

/** The user's requests about flight plans; nothing here throws. */
export interface PlanActions {
  readonly plans: PlanStore;
  /** Read it from the board; it becomes the draft. */
  readonly download: (plan: PlanName, asker: Asker) => Promise<void>;
  /**
   * Send the draft completely or not at all, and read it back. The board starts it at its first waypoint, or goes on to
   * the row `goOnTo`: that is commanded once the board has the plan, under the control of "go to".
   */
  readonly upload: (plan: PlanName, asker: Asker, goOnTo: number | null) => Promise<void>;
  /** Make the board load one of its built-in routes, and read it. `canRead`: the board can send its plan. */
  readonly loadRoute: (route: RouteCommand, canRead: boolean, asker: Asker) => Promise<void>;
  readonly importFile: (plan: PlanName, file: File, asker: Asker) => Promise<void>;
  /** Save the draft as a file of another program. */
  readonly exportFile: (plan: PlanName, format: PlanFormat, name: string, asker: Asker) => Promise<void>;
}

export const MISSIONS = partName<PlanActions>("missions");

export type RouteCommand = Extract<
  CommandName,
  "hil_load_gando" | "hil_load_ruta_isla" | "hil_load_alternativa" | "hil_load_vuelo"
>;

const KEY = "epf-gcs.plans";
const isDraft = list(
  shape({ latitude_deg: isNumber, longitude_deg: isNumber, altitude_ft: isNumber, speed_kt: isNumber }),
);

/** The plans with the drafts that this browser remembers: an unsent edit outlasts the page. */
export function createPlans(storage: BrowserStorage | null): PlanStore {
  const kept = read(storage);
  const store = createStore<Plans>(() => ({ flight: begin(kept["flight"]), hil: begin(kept["hil"]) }));
  store.subscribe((plans, before) => {
    if (PLANS.some((plan) => plans[plan].draft.present !== before[plan].draft.present)) {
      write(storage, { flight: plans.flight.draft.present, hil: plans.hil.draft.present });
    }
  });
  return store;
}

/** An edit of the draft; one step of its undo. */
export function editPlan(store: PlanStore, plan: PlanName, waypoints: readonly Waypoint[]): void {
  edit(store, plan, (draft) => edited(draft, waypoints));
}

/** The newest edit taken further; its undo takes back both. */
export function amendPlan(store: PlanStore, plan: PlanName, waypoints: readonly Waypoint[]): void {
  edit(store, plan, (draft) => amended(draft, waypoints));
}

export function undoPlan(store: PlanStore, plan: PlanName): void {
  edit(store, plan, undone);
}

export function redoPlan(store: PlanStore, plan: PlanName): void {
  edit(store, plan, redone);
}

/** Show the plan that the board had at a moment of the past; null: nobody knows. It cannot be edited. */
export function fixPlan(store: PlanStore, plan: PlanName, waypoints: readonly Waypoint[] | null): void {
  const { board, isFixed } = store.getState()[plan];
  const isSame = board === null || waypoints === null ? board === waypoints : samePlan(board, waypoints);
  if (!(isFixed && isSame)) {
    change(store, plan, () => ({ draft: begun(waypoints ?? []), board: waypoints, isFixed: true }));
  }
}

/** The board has this plan, as it says itself. */
export function boardHas(store: PlanStore, plan: PlanName, waypoints: readonly Waypoint[]): void {
  change(store, plan, () => ({ board: waypoints }));
}

/** Nobody knows any more what the board has: it is gone, or its plan was changed from elsewhere. */
export function forgetBoardPlan(store: PlanStore, plan: PlanName): void {
  if (store.getState()[plan].board !== null) {
    change(store, plan, () => ({ board: null }));
  }
}

export function notePlan(store: PlanStore, plan: PlanName, notes: readonly Message[]): void {
  change(store, plan, () => ({ notes }));
}

/** `empty`: nothing to send; `unknown`: what the board has is not known. */
export type PlanState = "empty" | "unknown" | "same" | "differs";

export function planState({ draft, board, isFixed }: Plan): PlanState {
  if (board === null) {
    return draft.present.length === 0 && !isFixed ? "empty" : "unknown";
  }
  return samePlan(draft.present, board) ? "same" : "differs";
}

function begin(waypoints: unknown): Plan {
  return { draft: begun(isDraft(waypoints) ? waypoints : []), board: null, notes: [], isFixed: false };
}

function edit(store: PlanStore, plan: PlanName, by: (draft: Plan["draft"]) => Plan["draft"]): void {
  change(store, plan, ({ draft, isFixed }) => (isFixed ? {} : { draft: by(draft) }));
}

function change(store: PlanStore, plan: PlanName, by: (before: Plan) => Partial<Plan>): void {
  store.setState((plans) => ({ [plan]: { ...plans[plan], ...by(plans[plan]) } }));
}

function read(storage: BrowserStorage | null): Readonly<Record<string, unknown>> {
  try {
    const value: unknown = JSON.parse(storage?.getItem(KEY) ?? "null");
    return isObject(value) ? value : {};
  } catch {
    return {};
  }
}

function write(
  storage: BrowserStorage | null,
  drafts: Readonly<Record<PlanName, readonly Waypoint[]>>,
): void {
  try {
    storage?.setItem(KEY, JSON.stringify(drafts));
  } catch {
    // Full or forbidden: the drafts last as long as the page.
  }
}
