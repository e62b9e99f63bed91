import { type Check, faultIn, isObject, isText } from "../lib/check";
import type { Answer, Problem, Refusal } from "../protocol/answers";

/** A file under way to the gateway. */
export interface UploadInit {
  readonly headers: Readonly<Record<string, string>>;
  readonly body: Blob;
  /** Called while it is sent, with the bytes so far. */
  readonly onSent: (bytes: number) => void;
  readonly signal: AbortSignal;
}

export interface RestOptions {
  readonly fetch: (path: string, init: RequestInit) => Promise<Response>;
  /** POSTs a file and tells how much of it is sent, which `fetch` cannot. Rejects like `fetch`. */
  readonly upload: (path: string, init: UploadInit) => Promise<Response>;
  /** Id of this page's stream connection, sent with its requests. */
  readonly client: () => string | null;
  /** Why this request may not be sent now; null if it may. */
  readonly refuse?: (method: string, path: string) => Problem | null;
}

/** Longer than any command with its repetition takes on the slowest link. */
const PATIENCE_MS = 15_000;

type Method = "GET" | "POST" | "PUT" | "PATCH" | "DELETE";

/** Sends requests to the gateway and never throws: the answer is a value or a problem. */
export class Rest {
  readonly #options: RestOptions;
  /** How many changes of each resource have ended. */
  readonly #changes = new Map<string, number>();

  constructor(options: RestOptions) {
    this.#options = options;
  }

  /**
   * Send a request and check its answer. A `Blob` is sent unchanged; any other body as JSON.
   * A question is asked again if a change of the same resource ended meanwhile: what it was told is perhaps of before.
   */
  async ask<T>(
    method: Method,
    path: string,
    check: Check<T>,
    body?: object,
    patience_ms = PATIENCE_MS,
  ): Promise<Answer<T>> {
    const resource = resourceOf(path);
    const before = this.#changes.get(resource);
    const answer = await this.#asked(method, path, check, body, patience_ms);
    if (method !== "GET") {
      this.#noteChange(resource);
    } else if (this.#changes.get(resource) !== before) {
      return this.ask(method, path, check, body, patience_ms);
    }
    return answer;
  }

  #noteChange(resource: string): void {
    this.#changes.set(resource, (this.#changes.get(resource) ?? 0) + 1);
  }

  async #asked<T>(
    method: Method,
    path: string,
    check: Check<T>,
    body: object | undefined,
    patience_ms: number,
  ): Promise<Answer<T>> {
    const answer = await this.#send(method, path, "application/json", body, patience_ms);
    if (!answer.ok) {
      return answer;
    }
    const value = await jsonOf(answer.value);
    if (value === UNREACHABLE) {
      return unreachable();
    }
    return check(value) ? { ok: true, value } : misfit(faultIn(check, value) ?? "");
  }

  /** A request whose answer is a file. */
  async file(path: string, body: object): Promise<Answer<Blob>> {
    const answer = await this.#send("POST", path, "*/*", body, PATIENCE_MS);
    if (!answer.ok) {
      return answer;
    }
    try {
      return { ok: true, value: await answer.value.blob() };
    } catch {
      return unreachable();
    }
  }

  /** A question whose answer is bytes. */
  async bytes(path: string, patience_ms = PATIENCE_MS): Promise<Answer<ArrayBuffer>> {
    const answer = await this.#send("GET", path, "application/octet-stream", undefined, patience_ms);
    if (!answer.ok) {
      return answer;
    }
    try {
      return { ok: true, value: await answer.value.arrayBuffer() };
    } catch {
      return unreachable();
    }
  }

  /** Send a file, with its progress; an abort of `signal` ends it as a problem `cancelled`. */
  async upload<T>(
    path: string,
    check: Check<T>,
    { body, onSent, signal }: Omit<UploadInit, "headers">,
  ): Promise<Answer<T>> {
    const refused = this.#options.refuse?.("POST", path) ?? null;
    if (refused !== null) {
      return { ok: false, problem: refused };
    }
    const client = this.#options.client();
    const headers = {
      accept: "application/json",
      "content-type": "application/octet-stream",
      ...(client === null ? {} : { "x-client": client }),
    };
    let response: Response;
    try {
      response = await this.#options.upload(path, { headers, body, onSent, signal });
    } catch {
      return signal.aborted ? failed("cancelled", "You cancelled it.") : unreachable();
    } finally {
      this.#noteChange(resourceOf(path));
    }
    const value = await jsonOf(response);
    if (!response.ok) {
      return { ok: false, problem: problemOf(value, response.status) };
    }
    return check(value) ? { ok: true, value } : misfit(faultIn(check, value) ?? "");
  }

  async #send(
    method: Method,
    path: string,
    accept: string,
    body: object | undefined,
    patience_ms: number,
  ): Promise<Answer<Response>> {
    const refused = this.#options.refuse?.(method, path) ?? null;
    if (refused !== null) {
      return { ok: false, problem: refused };
    }
    const client = this.#options.client();
    const isRaw = body instanceof Blob;
    let response: Response;
    try {
      response = await this.#options.fetch(path, {
        method,
        signal: AbortSignal.timeout(patience_ms),
        headers: {
          accept,
          ...(body === undefined
            ? {}
            : { "content-type": isRaw ? "application/octet-stream" : "application/json" }),
          ...(client === null ? {} : { "x-client": client }),
        },
        ...(body === undefined ? {} : { body: isRaw ? body : JSON.stringify(body) }),
      });
    } catch {
      return unreachable();
    }
    if (response.ok) {
      return { ok: true, value: response };
    }
    const problem = await jsonOf(response);
    return problem === UNREACHABLE
      ? unreachable()
      : { ok: false, problem: problemOf(problem, response.status) };
  }
}

/** What a request is about: the first name after the interface's version. */
function resourceOf(path: string): string {
  return path.split(/[/?]/, 4).join("/");
}

/** Marks an answer that broke off. */
const UNREACHABLE = Symbol("unreachable");

/** The JSON of an answer: null if it is empty, undefined if it is not JSON. */
async function jsonOf(response: Response): Promise<unknown> {
  let text: string;
  try {
    text = await response.text();
  } catch {
    return UNREACHABLE;
  }
  return text === "" ? null : parse(text);
}

function unreachable(): Refusal {
  return failed("gateway_unreachable", "The gateway does not answer: check that it runs, then try again.");
}

/** An answer that does not fit at this path of `faultIn`. */
function misfit(path: string): Refusal {
  const field = path.replace(/^\./, "");
  return field === ""
    ? failed("answer_unreadable", "The gateway's answer is not as agreed: load the page again.")
    : failed("answer_misfit", `The gateway's answer is not as agreed at ${field}: load the page again.`, {
        field,
      });
}

function failed(code: string, detail: string, params: Problem["params"] = {}): Refusal {
  return { ok: false, problem: { code, detail, params } };
}

function parse(text: string): unknown {
  try {
    return JSON.parse(text);
  } catch {
    return undefined;
  }
}

function problemOf(value: unknown, status: number): Problem {
  if (isObject(value) && isText(value["code"]) && isText(value["detail"])) {
    const { code, detail, params } = value;
    return { code, detail, params: isObject(params) ? params : {} };
  }
  return { code: "unexpected", detail: `The gateway answered with status ${status}.`, params: { status } };
}
