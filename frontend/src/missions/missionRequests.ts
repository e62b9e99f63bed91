import type { Waypoint } from "../lib/plan";
import type { Status } from "../protocol/contract";
import type { StreamEvent } from "../protocol/envelope";
import { isCommandOutcome, isMission, isMissionImport, isMissionRehearsal } from "../protocol/guards.gen";
import type { PlanName } from "../protocol/missions";
import { heightMessage } from "../readouts/heightSets";
import { resultMessage } from "../requests/actions";
import type { Asker } from "../requests/asking";
import { createAsking, info, type RequesterParts } from "../requests/asking";
import { wordsOf } from "../store/messages";
import { importPath, questionIn } from "./importQuestion";
import {
  askAboutFile,
  boardHas,
  editPlan,
  forgetBoardPlan,
  notePlan,
  type PlanActions,
  type PlanStore,
  takeImport,
} from "./planDrafts";
import { PLAN } from "./planFacts";

const PATH = "/api/v1/missions";
/** Time to send a hundred waypoints over a slow radio, each acknowledged, and to read them all back. */
const TRANSFER_MS = 120_000;
/** Longer than the gateway takes before it gives a rehearsal up. */
const REHEARSAL_MS = 10_000;

/** The requests about flight plans, with their outcome in the stores. */
export function createPlanActions(
  plans: PlanStore,
  saveFile: (name: string, content: Blob) => void,
  parts: RequesterParts,
): PlanActions {
  const { rest } = parts;
  const { run } = createAsking(parts);

  function download(plan: PlanName, asker: Asker): Promise<void> {
    const asked = rest.ask("GET", `${PATH}/${plan}`, isMission, undefined, TRANSFER_MS);
    return run(asker, asked, ({ waypoints }) => {
      boardHas(plans, plan, waypoints);
      editPlan(plans, plan, waypoints);
      notePlan(plans, plan, []);
      return { state: "confirmed", message: info("plans.saidDownloaded", named(plan, waypoints.length)) };
    });
  }

  /** Without the board's confirmation the message says that the plan may have been started again. */
  function goOn(plan: PlanName, index: number): Promise<void> {
    const body = { value: { plan: PLAN[plan].number, index } };
    const asked = rest.ask("POST", "/api/v1/commands/go_to_waypoint", isCommandOutcome, body);
    return run({ control: `plan.goTo.${plan}` }, asked, (result) => ({
      state: result.state,
      message:
        result.state === "confirmed"
          ? resultMessage("@command.go_to_waypoint", result)
          : { level: "error", key: "plans.saidNotGone", params: { number: index + 1 } },
    }));
  }

  return {
    plans,
    download,

    upload: async (plan, asker, goOnTo) => {
      const body = { waypoints: plans.getState()[plan].draft.present };
      const asked = rest.ask("PUT", `${PATH}/${plan}`, isMission, body, TRANSFER_MS);
      let isTaken = false;
      await run(asker, asked, ({ waypoints }) => {
        isTaken = true;
        boardHas(plans, plan, waypoints);
        const params = { what: `@planName.${plan}`, ...span(waypoints) };
        return { state: "confirmed", message: info("plans.saidUploaded", params) };
      });
      if (isTaken && goOnTo !== null) {
        await goOn(plan, goOnTo);
      }
    },

    rehearse: (plan, first, { start, wind, endurance_min }) => {
      const body = { waypoints: plans.getState()[plan].draft.present, first, start, wind, endurance_min };
      return rest.ask("POST", `${PATH}/rehearsal`, isMissionRehearsal, body, REHEARSAL_MS);
    },

    loadRoute: async (route, canRead, asker) => {
      let isTaken = false;
      await run(asker, rest.ask("POST", `/api/v1/commands/${route}`, isCommandOutcome, {}), (result) => {
        isTaken = result.state === "confirmed" || result.state === "sent";
        return { state: result.state, message: resultMessage(`@command.${route}`, result) };
      });
      if (isTaken && canRead) {
        await download("hil", asker);
      }
    },

    importPlan: async (plan, source, asker, answers = {}) => {
      const path = importPath(source, answers);
      const asked = await ("flight" in source
        ? rest.ask("GET", path, isMissionImport)
        : rest.ask("POST", path, isMissionImport, source));
      const question = asked.ok ? null : questionIn(asked.problem, { source, asker, answers });
      if (question !== null) {
        askAboutFile(plans, plan, question);
        return;
      }
      await run(asker, Promise.resolve(asked), ({ waypoints, notes, heights }) => {
        takeImport(plans, plan, waypoints);
        const said = notes.map(({ code, params }) => ({
          level: "warning" as const,
          key: `planNote.${code}`,
          params: wordsOf(params),
          fallback: code,
        }));
        const byHeights = heights.map((set) =>
          heightMessage(set, (height_ft) => `${Math.round(height_ft)} ft`),
        );
        notePlan(plans, plan, [...said, ...byHeights]);
        const params = { file: source.name, ...span(waypoints) };
        return { state: "confirmed", message: info("plans.saidImported", params) };
      });
    },

    exportFile: (plan, format, name, asker) => {
      const body = { name, waypoints: plans.getState()[plan].draft.present };
      return run(asker, rest.file(`${PATH}/export?format=${format}`, body), (content) => {
        const file = `${name}.${format}`;
        saveFile(file, content);
        return { state: "confirmed", message: info("plans.saidExported", { file }) };
      });
    },
  };
}

/** How many there are, and between which altitudes above the sea, feet. */
function span(waypoints: readonly Waypoint[]) {
  const altitudes_ft = waypoints.map(({ altitude_ft }) => Math.round(altitude_ft));
  return {
    count: waypoints.length,
    lowest_ft: Math.min(...altitudes_ft),
    highest_ft: Math.max(...altitudes_ft),
  };
}

function named(plan: PlanName, count: number) {
  return { what: `@planName.${plan}`, count };
}

/** The commands that load one of the board's own routes. */
const ROUTES: ReadonlySet<string> = new Set([
  "hil_load_gando",
  "hil_load_ruta_isla",
  "hil_load_alternativa",
  "hil_load_vuelo",
]);

/** Handle the stream's events about the board's plans: a plan that another client changes is no longer known here. */
export function takePlanEvent(plans: PlanStore, { event, data }: StreamEvent, client: string | null): void {
  if (event === "mission" && data.client !== client) {
    forgetBoardPlan(plans, data.plan);
  } else if (
    event === "command" &&
    ROUTES.has(data.name) &&
    // For this page's own transfer only its beginning counts: by its end the plan may have been read again.
    (data.client !== client || data.state === "pending")
  ) {
    forgetBoardPlan(plans, "hil");
  } else if (event === "board_restarted") {
    forgetBoardPlan(plans, "flight");
    forgetBoardPlan(plans, "hil");
  }
}

/** When the board is lost or is another one, its plans are unknown. */
export function takePlanStatus(
  plans: PlanStore,
  before: Status["board"] | null,
  board: Status["board"],
): void {
  const isOther = before !== null && (before.url !== board.url || before.reopened !== board.reopened);
  if (board.state !== "open" || isOther) {
    forgetBoardPlan(plans, "flight");
    forgetBoardPlan(plans, "hil");
  }
}
