import { isObject } from "../lib/check";

/** What the gateway says when it did not do something (RFC 9457), or what stands in for it when it says nothing. */
export interface Problem {
  /** Stable key, which the page translates. */
  readonly code: string;
  /** One clear English sentence: which, why, what to do. */
  readonly detail: string;
  readonly params: Readonly<Record<string, unknown>>;
}

export interface Refusal {
  readonly ok: false;
  readonly problem: Problem;
}

export type Answer<T> = { readonly ok: true; readonly value: T } | Refusal;

/** An answer whose content does not matter: that it came says that it was done. */
export function isDone(value: unknown): value is object | null {
  return value === null || isObject(value);
}
