import { isCommandOutcome, isPorts } from "../protocol/guards.gen";
import type { Actions } from "../store/actions";
import type { Outcome } from "../store/commands";
import { failureMessage, type Message } from "../store/messages";
import { type AskingParts, createAsking, info } from "./asking";

export interface ActionParts extends AskingParts {
  readonly client: () => string | null;
}

/** What a person can ask, as questions to the gateway with their progress in the stores. */
export function createActions(parts: ActionParts): Actions {
  const { rest } = parts;
  const { run, simply } = createAsking(parts);

  return {
    command: (name, asker, value) => {
      const body = value === undefined ? {} : { value };
      return run(asker, rest.ask("POST", `/api/v1/commands/${name}`, isCommandOutcome, body), (result) => ({
        state: result.state,
        message: resultMessage(`@command.${name}`, result),
      }));
    },

    setHil: (change, asker) => {
      const what =
        "source" in change ? `@command.hil_source_${change.source}` : `@command.hil_path_${change.path}`;
      return simply(asker, ["PUT", "/api/v1/hil", change], info("said.confirmed", { what }));
    },

    setStick: (change, asker) =>
      simply(
        asker,
        ["PUT", "/api/v1/hil", change],
        "gamepad" in change
          ? info("stickSaid.taken", { gamepad: change.gamepad })
          : info("stickSaid.simulator"),
      ),

    openBoard: (url, asker) =>
      simply(asker, ["PUT", "/api/v1/links/board", { url }], info("said.boardOpening", { url })),
    closeBoard: (asker) => simply(asker, ["DELETE", "/api/v1/links/board"], info("said.boardClosed")),

    openSimulator: (link, asker) =>
      simply(
        asker,
        ["PUT", "/api/v1/links/simulator", link],
        info("said.simulatorOpened", { port: link.receive_port }),
      ),
    closeSimulator: (asker) =>
      simply(asker, ["DELETE", "/api/v1/links/simulator"], info("said.simulatorClosed")),

    takeControl: (asker) =>
      simply(
        asker,
        ["POST", "/api/v1/control", { client: parts.client(), action: "take" }],
        info("said.controlTaken"),
      ),
    releaseControl: (asker) =>
      simply(
        asker,
        ["POST", "/api/v1/control", { client: parts.client(), action: "release" }],
        info("said.controlReleased"),
      ),

    listPorts: async () => {
      const answer = await rest.ask("GET", "/api/v1/ports", isPorts);
      return answer.ok
        ? answer.value.ports.map(({ path, description }) => ({ device: path, description }))
        : failureMessage(answer.problem);
    },
  };
}

interface Result {
  readonly state: Outcome;
  readonly by: string;
  readonly ms: number;
  readonly reason: string | null;
}

/** The sentence for what became of a command; also for what another browser's command became. */
export function resultMessage(what: string, { state, by, ms, reason }: Result): Message {
  switch (state) {
    case "confirmed":
      return info("said.confirmedBy", { what, by: `@by.${by}`, ms: Math.round(ms) });
    case "sent":
      return info("said.sent", { what });
    case "rejected":
      return {
        level: "error",
        key: "said.rejected",
        params: { what, reason: `@reason.${reason ?? "unknown"}` },
      };
    case "timed_out":
      return { level: "error", key: "said.timed_out", params: { what } };
  }
}
