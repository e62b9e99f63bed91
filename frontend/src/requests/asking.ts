import type { Check } from "../lib/check";
import { isDone } from "../protocol/answers";
import type { Asker } from "../store/actions";
import { begin, type CommandStore, finish, type Outcome } from "../store/commands";
import { failureMessage, type Message, type MessageStore, say } from "../store/messages";
import type { Answer, Rest } from "../transport/rest";

export interface AskingParts {
  readonly rest: Rest;
  readonly commands: CommandStore;
  readonly messages: MessageStore;
  /** Milliseconds of the page's clock, and of the calendar. */
  readonly now_ms: () => number;
  readonly wall_ms: () => number;
}

export interface Ended {
  readonly state: Outcome;
  readonly message: Message;
}

export type Question = readonly ["PUT" | "DELETE" | "POST", string, object?];

/** Questions to the gateway whose progress stands in the command store and whose outcome is said. */
export interface Asking {
  /** The outcome is worked out from the answer's value. */
  readonly run: <T>(asker: Asker, ask: Promise<Answer<T>>, end: (value: T) => Ended) => Promise<void>;
  /** The answer has nothing to say beyond that it was done. */
  readonly simply: (
    asker: Asker,
    question: Question,
    message: Message,
    check?: Check<object | null>,
  ) => Promise<void>;
}

export function createAsking({ rest, commands, messages, now_ms, wall_ms }: AskingParts): Asking {
  async function run<T>(asker: Asker, ask: Promise<Answer<T>>, end: (value: T) => Ended): Promise<void> {
    const entry = begin(commands, asker.control, asker.asked ?? null);
    const answer = await ask;
    const ended: Ended = answer.ok
      ? end(answer.value)
      : { state: "rejected", message: failureMessage(answer.problem) };
    finish(commands, asker.control, entry, ended, now_ms());
    say(messages, ended.message, wall_ms());
  }

  return {
    run,
    simply: (asker, [method, path, body], message, check = isDone) =>
      run(asker, rest.ask(method, path, check, body), () => ({ state: "confirmed", message })),
  };
}

export function info(key: string, params: Message["params"] = {}): Message {
  return { level: "info", key, params };
}
