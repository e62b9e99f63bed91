import { useTranslation } from "react-i18next";
import type { GainState } from "../../protocol/guards.gen";
import { useAsked } from "../../requests/useAsked";
import { NumberField } from "../../ui/NumberField";
import type { CommandState } from "../../ui/words";

/** What a gain may be. */
export interface GainLimits {
  readonly minimum: number;
  readonly maximum: number;
  readonly step: number;
  readonly isInteger: boolean;
}

interface Props {
  name: string;
  unit: string;
  limits: GainLimits;
  held: Pick<GainState, "state" | "value">;
  onCommit: (value: number) => void;
  disabledReason: string | undefined;
}

/**
 * One gain, editable. It shows what the board has; what was asked for only while that is on its way. Confirmed means
 * read back, and stays for as long as the board keeps the value; so does a refusal, with what the board has instead.
 */
export function GainField({ name, unit, limits, held, onCommit, disabledReason }: Props) {
  const { t } = useTranslation();
  const { state, stateText } = useGainOutcome(name, held);
  return (
    <NumberField
      label={name}
      // A "1" beside the number would be read as one of its digits.
      unit={unit === "1" ? undefined : unit}
      value={held.value}
      minimum={limits.minimum}
      maximum={limits.maximum}
      step={limits.step}
      refuse={(value) => (limits.isInteger && !Number.isInteger(value) ? t("params.whole") : null)}
      onCommit={onCommit}
      state={state}
      stateText={stateText}
      disabledReason={disabledReason}
    />
  );
}

/** What became of a gain's newest request, else what is known of its value; `text`: the value in words. */
export function useGainOutcome(
  name: string,
  { state: kept, value }: Pick<GainState, "state" | "value">,
  text: string | number | null = value,
): { readonly state: CommandState; readonly stateText: string | undefined } {
  const { t } = useTranslation();
  const asked = useAsked(`parameter.${name}`);
  const keptState = kept === "unknown" || kept === "loaded" ? "idle" : kept;
  const keptText =
    kept === "rejected"
      ? t("params.refusedText", { value: text ?? t("words.unknown") })
      : value === null
        ? t("params.unknown")
        : undefined;
  return {
    state: asked.state === "idle" ? keptState : asked.state,
    stateText: asked.stateText ?? keptText,
  };
}
