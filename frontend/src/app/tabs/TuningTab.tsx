import { ParameterField } from "../../features/parameters/ParameterField";
import { useFreshParameters } from "../../features/parameters/useFreshParameters";
import { TuningDock } from "../../features/tuning/TuningDock";
import type { ParameterName } from "../../protocol/messages.gen";

function field(name: ParameterName) {
  return <ParameterField name={name} />;
}

/** The tuning view, with the fields of the gains that it changes. */
export function TuningTab() {
  useFreshParameters();
  return <TuningDock field={field} />;
}
