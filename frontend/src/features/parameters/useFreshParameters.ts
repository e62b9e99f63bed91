import { useEffect } from "react";
import { PARAMETERS, type ParameterInfo, type ParameterName } from "../../protocol/messages.gen";
import { useConnection, usePart } from "../../store/hooks";
import { PARAMETER_REQUESTS } from "./parameterValues";

/** The definition of each parameter by its name. */
export const INFO = Object.fromEntries(PARAMETERS.map((info) => [info.name, info])) as Readonly<
  Record<ParameterName, ParameterInfo>
>;

/**
 * Keeps the page's copy of the gains and their journal up to date while this is shown; nothing is asked of the board.
 */
export function useFreshParameters(): void {
  const parameters = usePart(PARAMETER_REQUESTS);
  const isOpen = useConnection(({ phase }) => phase === "open");
  const client = useConnection((connection) => connection.client);
  useEffect(() => {
    if (isOpen && client !== null) {
      void parameters.refresh();
    }
  }, [parameters, isOpen, client]);
}
