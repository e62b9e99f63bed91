import { useTranslation } from "react-i18next";
import type { GainState } from "../../protocol/guards.gen";
import type { ParameterName } from "../../protocol/messages.gen";
import { useAsked } from "../../requests/useAsked";
import { useBoardBlocked } from "../../requests/useBlocked";
import { usePart } from "../../store/hooks";
import { NumberField } from "../../ui/NumberField";
import type { CommandState } from "../../ui/words";
import { PARAMETER_REQUESTS, useParameters } from "./parameterValues";
import { INFO } from "./useFreshParameters";

/**
 * One gain, editable. It shows what the board has; what was asked for only while that is on its way. Confirmed means
 * read back, and stays for as long as the board keeps the value; so does a refusal, with what the board has instead.
 */
export function ParameterField({ name }: { name: ParameterName }) {
  const { t } = useTranslation();
  const parameters = usePart(PARAMETER_REQUESTS);
  const held = useParameters((values) => values.held[name]);
  const asked = useAsked(`parameter.${name}`);
  const blocked = useBoardBlocked();
  const info = INFO[name];
  const unit = t(`paramUnit.${name}`);
  const state = asked.state === "idle" ? keptState(held) : asked.state;
  return (
    <NumberField
      label={name}
      // A "1" beside the number would be read as one of its digits.
      unit={unit === "1" ? undefined : unit}
      value={held.value}
      minimum={info.minimum}
      maximum={info.maximum}
      step={info.step}
      refuse={(value) => (info.isInteger && !Number.isInteger(value) ? t("params.whole") : null)}
      onCommit={(value) => void parameters.edit(name, value)}
      state={state}
      stateText={asked.stateText ?? keptText(held)}
      disabledReason={blocked}
    />
  );

  function keptText({ state: kept, value }: GainState): string | undefined {
    if (kept === "rejected") {
      return t("params.refusedText", { value: value ?? t("words.unknown") });
    }
    return value === null ? t("params.unknown") : undefined;
  }
}

function keptState({ state }: GainState): CommandState {
  return state === "unknown" || state === "loaded" ? "idle" : state;
}
