import type { Check } from "../lib/check";
import { isCommandResult, isDone, isPorts } from "../protocol/answers";
import type { Actions, Asker } from "../store/actions";
import { begin, type CommandStore, finish, type Outcome } from "../store/commands";
import { failureMessage, type Message, type MessageStore, say } from "../store/messages";
import type { Answer, Rest } from "../transport/rest";

export interface ActionParts {
  readonly rest: Rest;
  readonly commands: CommandStore;
  readonly messages: MessageStore;
  readonly client: () => string | null;
  /** Milliseconds of the page's clock, and of the calendar. */
  readonly now_ms: () => number;
  readonly wall_ms: () => number;
}

interface Ended {
  readonly state: Outcome;
  readonly message: Message;
}

function info(key: string, params: Message["params"] = {}): Message {
  return { level: "info", key, params };
}

/** What a person can ask, as questions to the gateway with their progress in the stores. */
export function createActions(parts: ActionParts): Actions {
  const { rest, commands, messages } = parts;

  async function run<T>(asker: Asker, ask: Promise<Answer<T>>, end: (value: T) => Ended): Promise<void> {
    const entry = begin(commands, asker.control, asker.asked ?? null);
    const answer = await ask;
    const ended: Ended = answer.ok
      ? end(answer.value)
      : { state: "rejected", message: failureMessage(answer.problem) };
    finish(commands, asker.control, entry, ended, parts.now_ms());
    say(messages, ended.message, parts.wall_ms());
  }

  /** A question whose answer has nothing to say beyond that it was done. */
  function simply(
    asker: Asker,
    [method, path, body]: readonly ["PUT" | "DELETE" | "POST", string, object?],
    message: Message,
    check: Check<object | null> = isDone,
  ): Promise<void> {
    return run(asker, rest.ask(method, path, check, body), () => ({ state: "confirmed", message }));
  }

  return {
    command: (name, asker, value) => {
      const body = value === undefined ? {} : { value };
      return run(asker, rest.ask("POST", `/api/v1/commands/${name}`, isCommandResult, body), (result) => ({
        state: result.state,
        message: resultMessage(`@command.${name}`, result),
      }));
    },

    setHil: (change, asker) => {
      const what =
        "source" in change ? `@command.hil_source_${change.source}` : `@command.hil_path_${change.path}`;
      return simply(asker, ["PUT", "/api/v1/hil", change], info("said.confirmed", { what }));
    },

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
