import type { ParameterJournal } from "./guards.gen";

export type { JournalEntry } from "./guards.gen";

export type Journal = ParameterJournal;
/** What an undo or redo would write now; null where there is nothing. */
export type ParameterMoves = Journal["undo"];
