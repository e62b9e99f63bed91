import { type Checked, isNumber, isObject, isText, list, nullable, oneOf, shape } from "../lib/check";
import type { components } from "./api.gen";

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

/** What became of a command. `reason` is the board's own, where it refused. */
export const isCommandResult = shape({
  state: oneOf("confirmed", "rejected", "timed_out", "sent"),
  by: isText,
  ms: isNumber,
  reason: nullable(isText),
});

export const isPorts = shape({ ports: list(shape({ path: isText, description: isText })) });

/** An answer whose content does not matter: that it came says that it was done. */
export function isDone(value: unknown): value is object | null {
  return value === null || isObject(value);
}

type Described = components["schemas"];
/** Do not compile when the gateway describes its answers otherwise than they are checked here. */
export const outcomeIsAsDescribed: Described["CommandOutcome"] extends Checked<typeof isCommandResult>
  ? true
  : false = true;
export const portsAreAsDescribed: Described["Ports"] extends Checked<typeof isPorts> ? true : false = true;
