import { isObject } from "../lib/check";

/** An answer whose content does not matter: that it came says that it was done. */
export function isDone(value: unknown): value is object | null {
  return value === null || isObject(value);
}
