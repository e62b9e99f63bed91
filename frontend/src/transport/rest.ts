import { type Check, isObject, isText } from "../lib/check";

/** What the gateway says when it did not do something (RFC 9457), or what stands in for it when it says nothing. */
export interface Problem {
  /** Stable key, which the page translates. */
  readonly code: string;
  /** One clear English sentence: which, why, what to do. */
  readonly detail: string;
  readonly params: Readonly<Record<string, unknown>>;
}

export type Answer<T> =
  | { readonly ok: true; readonly value: T }
  | { readonly ok: false; readonly problem: Problem };

export interface RestOptions {
  readonly fetch: (path: string, init: RequestInit) => Promise<Response>;
  /** Name of this page's stream connection, which its requests carry. */
  readonly client: () => string | null;
}

/** Longer than any command takes with its repetition on the slowest line. */
const PATIENCE_MS = 15_000;

type Method = "GET" | "POST" | "PUT" | "DELETE";

/** Asks the gateway and never throws: an answer is what was asked for, or a problem. */
export class Rest {
  readonly #options: RestOptions;

  constructor(options: RestOptions) {
    this.#options = options;
  }

  async ask<T>(method: Method, path: string, check: Check<T>, body?: object): Promise<Answer<T>> {
    const client = this.#options.client();
    let response: Response;
    let value: unknown;
    try {
      response = await this.#options.fetch(path, {
        method,
        signal: AbortSignal.timeout(PATIENCE_MS),
        headers: {
          accept: "application/json",
          ...(body === undefined ? {} : { "content-type": "application/json" }),
          ...(client === null ? {} : { "x-client": client }),
        },
        ...(body === undefined ? {} : { body: JSON.stringify(body) }),
      });
      const text = await response.text();
      value = text === "" ? null : parse(text);
    } catch {
      return failed(
        "gateway_unreachable",
        "The gateway does not answer: check that it runs, then try again.",
      );
    }
    if (!response.ok) {
      return { ok: false, problem: problemOf(value, response.status) };
    }
    return check(value)
      ? { ok: true, value }
      : failed("answer_unreadable", "The gateway's answer is not as agreed: load the page again.");
  }
}

function failed(code: string, detail: string): { readonly ok: false; readonly problem: Problem } {
  return { ok: false, problem: { code, detail, params: {} } };
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
