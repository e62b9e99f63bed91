import { isNumber, isObject, isText, list, nullable, oneOf, shape } from "../lib/check";

/** What became of a command. `reason` is the board's own, where it refused. */
export const isCommandResult = shape({
  state: oneOf("confirmed", "rejected", "timed_out", "sent"),
  by: isText,
  ms: isNumber,
  reason: nullable(isText),
});

export const isPorts = list(shape({ path: isText, description: isText }));

/** An answer whose content does not matter: that it came says that it was done. */
export function isDone(value: unknown): value is object | null {
  return value === null || isObject(value);
}
