import type { Check } from "../lib/check";
import { type Answer, isDone } from "../protocol/answers";
import { begin, type CommandStore, finish, type Outcome } from "../store/commands";
import { failureMessage, type Message, type MessageStore } from "../store/messages";

/** The gateway's REST interface; never throws: the answer is a value or a problem. */
export interface Gateway {
  /** Send a request and check its answer. */
  readonly ask: <T>(
    method: "GET" | "POST" | "PUT" | "PATCH" | "DELETE",
    path: string,
    check: Check<T>,
    body?: object,
    patience_ms?: number,
  ) => Promise<Answer<T>>;
  readonly file: (path: string, body: object) => Promise<Answer<Blob>>;
  readonly bytes: (path: string, patience_ms?: number) => Promise<Answer<ArrayBuffer>>;
  /** Send a file, with the bytes sent so far; an abort ends it with the problem `cancelled`. */
  readonly upload: <T>(
    path: string,
    check: Check<T>,
    file: {
      readonly body: Blob;
      readonly onSent: (bytes: number) => void;
      readonly signal: AbortSignal;
    },
  ) => Promise<Answer<T>>;
}

/** The control that made the request, so that it can show the outcome; `asked` is the requested position. */
export interface Asker {
  readonly control: string;
  readonly asked?: string;
}

export interface RequesterParts {
  readonly rest: Gateway;
  readonly commands: CommandStore;
  readonly messages: MessageStore;
  /** Milliseconds of the page's clock, and Unix milliseconds. */
  readonly now_ms: () => number;
  readonly wall_ms: () => number;
}

export interface RequestEnd {
  readonly state: Outcome;
  readonly message: Message;
}

export type Question = readonly ["PUT" | "DELETE" | "POST", string, object?];

/** Requests whose progress is in the command store and whose outcome is announced. */
export interface Requester {
  /** For a request whose outcome depends on the answer's value. */
  readonly run: <T>(asker: Asker, ask: Promise<Answer<T>>, end: (value: T) => RequestEnd) => Promise<void>;
  /** For a request whose answer only means that it was done. */
  readonly simply: (
    asker: Asker,
    question: Question,
    message: Message,
    check?: Check<object | null>,
  ) => Promise<void>;
}

export function createAsking({ rest, commands, messages, now_ms }: RequesterParts): Requester {
  async function run<T>(asker: Asker, ask: Promise<Answer<T>>, end: (value: T) => RequestEnd): Promise<void> {
    const entry = begin(commands, asker.control, asker.asked ?? null);
    const answer = await ask;
    const ended: RequestEnd = answer.ok
      ? end(answer.value)
      : { state: "rejected", message: failureMessage(answer.problem) };
    finish(commands, asker.control, entry, ended, now_ms());
    messages.say(ended.message);
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
