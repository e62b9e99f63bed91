import type { AdviceState, Inspector } from "./guards.gen";

export type { InspectedFrame, InspectedRow } from "./guards.gen";

/** Everything that goes over the lines, as the gateway counted it. */
export type Inspection = Inspector;
export type Advice = AdviceState;
