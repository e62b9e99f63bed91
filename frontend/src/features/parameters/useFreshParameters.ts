import { PARAMETERS, type ParameterInfo, type ParameterName } from "../../protocol/messages.gen";
import { useFresh } from "../../requests/useFresh";
import { usePart } from "../../store/hooks";
import { PARAMETER_REQUESTS } from "./parameterValues";

/** The definition of each parameter by its name. */
export const INFO = Object.fromEntries(PARAMETERS.map((info) => [info.name, info])) as Readonly<
  Record<ParameterName, ParameterInfo>
>;

/**
 * Keeps the page's copy of the gains and their journal up to date while this is shown; nothing is asked of the board.
 */
export function useFreshParameters(): void {
  useFresh(usePart(PARAMETER_REQUESTS).refresh);
}
