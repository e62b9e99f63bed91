import { useTranslation } from "react-i18next";
import type { ParameterName } from "../../protocol/messages.gen";
import { useBoardBlocked } from "../../requests/useBlocked";
import { usePart } from "../../store/hooks";
import { GainField } from "./GainField";
import { PARAMETER_REQUESTS, useParameters } from "./parameterValues";
import { INFO } from "./useFreshParameters";

/** One of the 17 gains, editable. */
export function ParameterField({ name }: { name: ParameterName }) {
  const { t } = useTranslation();
  const parameters = usePart(PARAMETER_REQUESTS);
  const held = useParameters((values) => values.held[name]);
  return (
    <GainField
      name={name}
      unit={t(`paramUnit.${name}`)}
      limits={INFO[name]}
      held={held}
      onCommit={(value) => void parameters.edit(name, value)}
      disabledReason={useBoardBlocked()}
    />
  );
}
