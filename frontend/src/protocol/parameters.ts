import { type Checked, dictionary, isNumber, isText, list, nullable, oneOf, shape } from "../lib/check";
import { PARAMETERS, type ParameterName } from "./messages.gen";

const isParameterState = oneOf("unknown", "loaded", "pending", "confirmed", "rejected");
const isParameterName = oneOf(...PARAMETERS.map(({ name }) => name));
const isOutcome = oneOf("confirmed", "rejected", "timed_out");

/** What the gateway knows of a gain: null is not known. `loaded` is what it was when all were last loaded. */
const isHeld = shape({ value: nullable(isNumber), loaded: nullable(isNumber), state: isParameterState });
export type HeldParameter = Checked<typeof isHeld>;

export const isParameterList = shape({
  parameters: list(
    shape({
      name: isParameterName,
      value: nullable(isNumber),
      loaded: nullable(isNumber),
      state: isParameterState,
    }),
  ),
});
export type ListedParameters = Checked<typeof isParameterList>;
/** What changed, by name. */
export const isParameterEvent = shape({ parameters: dictionary(isHeld) });

/** One step: who wrote what when. `before` is null where it was not known. */
const isEntry = shape({
  id: isNumber,
  t_s: isNumber,
  client: nullable(isText),
  name: nullable(isText),
  kind: oneOf("write", "undo", "redo"),
  state: isOutcome,
  changes: list(
    shape({ name: isParameterName, before: nullable(isNumber), after: isNumber, state: isOutcome }),
  ),
});
export type JournalEntry = Checked<typeof isEntry>;

/** What an undo or redo would write now; null where there is nothing. */
const isMoves = nullable(list(shape({ name: isParameterName, before: isNumber, after: isNumber })));
export type ParameterMoves = Checked<typeof isMoves>;

export const isJournal = shape({ entries: list(isEntry), undo: isMoves, redo: isMoves });
export type Journal = Checked<typeof isJournal>;
/** `entry` is null where only what can be undone has changed. */
export const isJournalEvent = shape({ entry: nullable(isEntry), undo: isMoves, redo: isMoves });

export function isKnownParameter(name: string): name is ParameterName {
  return isParameterName(name);
}
