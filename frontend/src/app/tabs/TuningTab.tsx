import { useMemo } from "react";
import { ParameterField } from "../../features/parameters/ParameterField";
import { useParameters } from "../../features/parameters/parameterValues";
import { useFreshParameters } from "../../features/parameters/useFreshParameters";
import { TuningDock } from "../../features/tuning/TuningDock";
import { PARAMETERS, type ParameterName } from "../../protocol/messages.gen";

function field(name: ParameterName) {
  return <ParameterField name={name} />;
}

/** The tuning view, with the fields of the gains that it changes, and what the board has of them. */
export function TuningTab() {
  useFreshParameters();
  const held = useParameters((parameters) => parameters.held);
  const values = useMemo(
    () =>
      Object.fromEntries(PARAMETERS.map(({ name }) => [name, held[name].value])) as Readonly<
        Record<ParameterName, number | null>
      >,
    [held],
  );
  return <TuningDock field={field} values={values} />;
}
