import type { LineLaw } from "../../missions/lineLaw";
import { type ParameterActions, type ParameterValues, stateOf } from "./parameterValues";

/** The line law as the board's own gains tell it. */
export function lineLawOf({ values, refresh }: Pick<ParameterActions, "values" | "refresh">): LineLaw {
  return { bank_deg: () => bankOf(values.getState()), subscribe: values.subscribe, refresh };
}

function bankOf(values: ParameterValues): number | null {
  const law = values.own.table.gains.find(({ name }) => name === "guidance_law");
  const chosen = stateOf(values, "guidance_law").value;
  const isLine = law !== undefined && chosen !== null && law.choices[chosen] === "line";
  return isLine ? stateOf(values, "line_bank_limit").value : null;
}
