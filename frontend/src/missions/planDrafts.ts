import { useStore } from "zustand";
import { createStore, type StoreApi } from "zustand/vanilla";
import { isNumber, isObject, list, shape } from "../lib/check";
import { amended, begun, edited, type History, redone, undone } from "../lib/history";
import { samePlan, type Waypoint } from "../lib/plan";
import type { PlanIssue } from "../lib/planCheck";
import type { Answer } from "../protocol/answers";
import { type ImportedWaypoint, isImportedWaypoint, type MissionRehearsal } from "../protocol/guards.gen";
import type { CommandName } from "../protocol/messages.gen";
import { PLANS, type PlanFormat, type PlanName } from "../protocol/missions";
import type { Asker } from "../requests/asking";
import { usePart } from "../store/hooks";
import type { Message } from "../store/messages";
import { partName } from "../store/parts";
import type { BrowserStorage } from "../store/settings";
import type { ImportAnswers, ImportQuestion, PlanSource } from "./importQuestion";
import type { FlightConditions } from "./rehearsal";

/** A flight plan: the draft, and the board's. */
export interface Plan {
  readonly draft: History<readonly Waypoint[]>;
  /** The board's plan, as read back; null if unknown. */
  readonly board: readonly Waypoint[] | null;
  /** The assumptions made when the draft was read from a file. */
  readonly notes: readonly Message[];
  /** What its file had, with the heights from which its altitudes were converted; empty if none were. */
  readonly imported: readonly ImportedWaypoint[];
  /** Where the draft leaves the fence or meets the ground, as far as a map has worked it out. */
  readonly hazards: PlanHazards;
  /** What a person has to say about a file before it is read; null: nothing. */
  readonly question: ImportQuestion | null;
  /** A plan of the past: it is shown as it was, and no edit changes it. */
  readonly isFixed: boolean;
}

/** The hazards of a plan's geometry, and the waypoints that they are of: others have none that are known. */
export interface PlanHazards {
  readonly of: readonly Waypoint[] | null;
  readonly issues: readonly PlanIssue[];
}

const NO_HAZARDS: PlanHazards = { of: null, issues: [] };

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
  /** Have the draft flown in the gateway's model, from row `first` on; nothing reaches the board. */
  readonly rehearse: (
    plan: PlanName,
    first: number,
    conditions: FlightConditions,
  ) => Promise<Answer<MissionRehearsal>>;
  /** Make the board load one of its built-in routes, and read it. `canRead`: the board can send its plan. */
  readonly loadRoute: (route: RouteCommand, canRead: boolean, asker: Asker) => Promise<void>;
  /** Read a file, or a flown track, as the draft. What only a person can say about it becomes the plan's question. */
  readonly importPlan: (
    plan: PlanName,
    source: PlanSource,
    asker: Asker,
    answers?: ImportAnswers,
  ) => Promise<void>;
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
const isImported = list(isImportedWaypoint);
/** Key of what a plan's file had, beside the plan's own. */
const IMPORTED = { flight: "flightImported", hil: "hilImported" } as const;

/** The plans with the drafts that this browser remembers: an unsent edit outlasts the page. */
export function createPlans(storage: BrowserStorage | null): PlanStore {
  const kept = read(storage);
  const store = createStore<Plans>(() => ({
    flight: begin(kept["flight"], kept[IMPORTED.flight]),
    hil: begin(kept["hil"], kept[IMPORTED.hil]),
  }));
  store.subscribe((plans, before) => {
    const isOther = (plan: PlanName): boolean =>
      plans[plan].draft.present !== before[plan].draft.present ||
      plans[plan].imported !== before[plan].imported;
    if (PLANS.some(isOther)) {
      write(storage, plans);
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

/** The draft is what this file had; one step of its undo. */
export function takeImport(store: PlanStore, plan: PlanName, imported: readonly ImportedWaypoint[]): void {
  editPlan(
    store,
    plan,
    imported.map(({ latitude_deg, longitude_deg, altitude_ft, speed_kt }) => ({
      latitude_deg,
      longitude_deg,
      altitude_ft,
      speed_kt,
    })),
  );
  change(store, plan, () => ({ imported: imported.filter(({ origin }) => origin !== null) }));
}

/** These waypoints have these hazards. */
export function noteHazards(store: PlanStore, plan: PlanName, hazards: PlanHazards): void {
  change(store, plan, () => ({ hazards }));
}

/** The hazards of the plan's draft; empty while none are known. */
export function hazardsOf({ draft, hazards }: Plan): readonly PlanIssue[] {
  return hazards.of === draft.present ? hazards.issues : NO_HAZARDS.issues;
}

/** Ask this about a file; null: the question was answered, or dropped with its file. */
export function askAboutFile(store: PlanStore, plan: PlanName, question: ImportQuestion | null): void {
  change(store, plan, () => ({ question }));
}

/** `empty`: nothing to send; `unknown`: what the board has is not known. */
export type PlanState = "empty" | "unknown" | "same" | "differs";

export function planState({ draft, board, isFixed }: Plan): PlanState {
  if (board === null) {
    return draft.present.length === 0 && !isFixed ? "empty" : "unknown";
  }
  return samePlan(draft.present, board) ? "same" : "differs";
}

function begin(waypoints: unknown, imported: unknown): Plan {
  return {
    draft: begun(isDraft(waypoints) ? waypoints : []),
    board: null,
    notes: [],
    imported: isImported(imported) ? imported : [],
    hazards: NO_HAZARDS,
    question: null,
    isFixed: false,
  };
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

function write(storage: BrowserStorage | null, plans: Plans): void {
  try {
    const kept = PLANS.flatMap((plan) => [
      [plan, plans[plan].draft.present],
      ...(plans[plan].imported.length > 0 ? [[IMPORTED[plan], plans[plan].imported]] : []),
    ]);
    storage?.setItem(KEY, JSON.stringify(Object.fromEntries(kept)));
  } catch {
    // Full or forbidden: the drafts last as long as the page.
  }
}

export function usePlans<T>(select: (plans: Plans) => T): T {
  return useStore(usePart(MISSIONS).plans, select);
}
