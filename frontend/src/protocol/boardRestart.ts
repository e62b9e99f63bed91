import { isNumber, isText, list, nullable, oneOf, shape } from "../lib/check";
import { PLANS } from "./missions";

/** The event that tells of a board that started anew in the midst of its work. */
export const BOARD_RESTARTED = "board_restarted";

export const isBoardRestart = shape({
  /** For how long it was not heard; null where nobody measured it. */
  silent_s: nullable(isNumber),
  /** Gains that were not on the board's card, and plans that it had. */
  parameters: list(isText),
  plans: list(oneOf(...PLANS)),
});
