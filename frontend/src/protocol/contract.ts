import type { AdviceState, AlarmState, Inspector, ParameterJournal } from "./guards.gen";

export type { InspectedFrame, InspectedRow, JournalEntry, Status } from "./guards.gen";

export type Alarm = AlarmState;
/** Everything that goes over the lines, as the gateway counted it. */
export type Inspection = Inspector;
export type Advice = AdviceState;
export type Journal = ParameterJournal;
/** What an undo or redo would write now; null where there is nothing. */
export type ParameterMoves = Journal["undo"];
