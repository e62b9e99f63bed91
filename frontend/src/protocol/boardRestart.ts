import { isNumber, isText, list, nullable, oneOf, shape } from "../lib/check";
import { PLANS } from "./missions";

/** The event that reports an unexpected restart of the board. */
export const BOARD_RESTARTED = "board_restarted";

export const isBoardRestart = shape({
  /** How long it was silent; null if not measured. */
  silent_s: nullable(isNumber),
  /** Gains that were not on the board's card, and plans that it had. */
  parameters: list(isText),
  plans: list(oneOf(...PLANS)),
});
