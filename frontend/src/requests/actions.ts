import { isCommandOutcome, isNearbySimulators, isPorts, type NearbySimulator } from "../protocol/guards.gen";
import type { CommandName } from "../protocol/messages.gen";
import type { Outcome } from "../store/commands";
import { failureMessage, type Message } from "../store/messages";
import { partName } from "../store/parts";
import type { Asker } from "./asking";
import { createAsking, info, type RequesterParts } from "./asking";
/** A serial port of the gateway's computer. */
export interface Port {
  readonly device: string;
  readonly description: string;
}

export interface SimulatorLink {
  readonly receive_port: number;
  readonly send_host: string;
  readonly send_port: number;
  readonly profile: "xp10" | "xp12";
  /** Whether an X-Plane is told which rows to send, and where to. */
  readonly tells_rows: boolean;
}

/**
 * What a page wants of control. `confirm`: take it from whoever has it, which only an owner may. `to`: the client that
 * asked, or that gets it.
 */
export type ControlChange =
  | { readonly action: "take"; readonly confirm?: true }
  | { readonly action: "release" | "ask" | "withdraw" }
  | { readonly action: "grant" | "refuse" | "hand_over"; readonly to: string };

/** Arguments of a command: one number, or several by name. */
export type CommandValue = number | Readonly<Record<string, number>>;

/**
 * The user's requests to the gateway. Each writes its progress to the command store under the asker's name, and its
 * outcome to the messages. None throws; the promise only says that it is over.
 */
export interface Actions {
  readonly command: (name: CommandName, asker: Asker, value?: CommandValue) => Promise<void>;
  readonly setHil: (
    change: { readonly source: "joystick" | "rc" } | { readonly path: "manual" | "assisted" },
    asker: Asker,
  ) => Promise<void>;
  /** Choose the pilot's stick: the simulator's, or this page's gamepad by its name. */
  readonly setStick: (
    change: { readonly stick: "simulator" } | { readonly stick: "gamepad"; readonly gamepad: string },
    asker: Asker,
  ) => Promise<void>;
  readonly openBoard: (url: string, asker: Asker) => Promise<void>;
  readonly closeBoard: (asker: Asker) => Promise<void>;
  readonly openSimulator: (link: SimulatorLink, asker: Asker) => Promise<void>;
  readonly closeSimulator: (asker: Asker) => Promise<void>;
  readonly changeControl: (change: ControlChange, asker: Asker) => Promise<void>;
  /** The ports, or the message of the failure. */
  readonly listPorts: () => Promise<readonly Port[] | Message>;
  /** The X-Planes on the station's networks; none where that cannot be read. */
  readonly listSimulators: () => Promise<readonly NearbySimulator[]>;
}

export const ACTIONS = partName<Actions>("actions");

export interface ActionParts extends RequesterParts {
  readonly client: () => string | null;
}

/** Makes the user's requests, with their progress in the stores. */
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

    changeControl: (change, asker) =>
      simply(
        asker,
        ["POST", "/api/v1/control", { client: parts.client(), ...change }],
        info(`controlAsked.${change.action}`),
      ),

    listPorts: async () => {
      const answer = await rest.ask("GET", "/api/v1/ports", isPorts);
      return answer.ok
        ? answer.value.ports.map(({ path, description }) => ({ device: path, description }))
        : failureMessage(answer.problem);
    },

    listSimulators: async () => {
      const answer = await rest.ask("GET", "/api/v1/simulators", isNearbySimulators);
      return answer.ok ? answer.value.simulators : [];
    },
  };
}

interface Result {
  readonly state: Outcome;
  readonly by: string;
  readonly ms: number;
  readonly reason: string | null;
}

/** The message for a command's outcome, also for another browser's command. */
export function resultMessage(what: string, { state, by, ms, reason }: Result): Message {
  switch (state) {
    case "confirmed":
      return info("said.confirmedBy", { what, by: `@by.${by}`, ms: ms < 1 ? "<1" : Math.round(ms) });
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
