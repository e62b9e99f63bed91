import { type Checked, dictionary, nullable, shape } from "../lib/check";
import { isJournalEntry, isParameterJournal, isParameterState, type ParameterJournal } from "./guards.gen";

const { value, loaded, state } = isParameterState.fields;
/** What the gateway knows of a gain: null is not known. `loaded` is what it was when all were last loaded. */
const isHeld = shape({ value, loaded, state });
export type HeldParameter = Checked<typeof isHeld>;

/** What changed, by name. */
export const isParameterEvent = shape({ parameters: dictionary(isHeld) });

export type { JournalEntry } from "./guards.gen";

export type Journal = ParameterJournal;
/** What an undo or redo would write now; null where there is nothing. */
export type ParameterMoves = Journal["undo"];

const { undo, redo } = isParameterJournal.fields;
/** `entry` is null where only what can be undone has changed. */
export const isJournalEvent = shape({ entry: nullable(isJournalEntry), undo, redo });
