import { ChartSpline, RotateCcw } from "lucide-react";
import { useTranslation } from "react-i18next";
import type { ParameterName } from "../../protocol/messages.gen";
import { loopOf } from "../../protocol/tuning";
import { useBoardBlocked } from "../../requests/useBlocked";
import { usePage } from "../../store/hooks";
import { choose } from "../../store/settings";
import { Button } from "../../ui/Button";
import { GainMarks } from "./GainMarks";
import { ParameterField } from "./ParameterField";
import { useParameters } from "./parameterValues";
import { INFO } from "./useFreshParameters";

interface Props {
  name: ParameterName;
  /** Ask whether this one shall have its default. */
  onReset: (name: ParameterName) => void;
}

/** A gain with its range, its default, and what it differs from. */
export function ParameterRow({ name, onReset }: Props) {
  const { t } = useTranslation();
  const { settings } = usePage();
  const held = useParameters((values) => values.held[name]);
  const blocked = useBoardBlocked();
  const info = INFO[name];
  return (
    <div className="params-row" data-parameter={name}>
      <ParameterField name={name} />
      <GainMarks held={held} standard={info.default} />
      <div className="params-actions">
        <Button
          onPress={() => onReset(name)}
          icon={<RotateCcw aria-hidden="true" size={14} />}
          label={t("params.resetOne", { name })}
          disabledReason={blocked ?? (held.value === info.default ? t("params.isDefault") : undefined)}
        >
          {null}
        </Button>
        <Button
          onPress={() => choose(settings, "tuning.loop", loopOf(name))}
          icon={<ChartSpline aria-hidden="true" size={14} />}
          label={t("params.tune", { name })}
        >
          {null}
        </Button>
      </div>
      <p className="params-doc">
        <span>{t(`paramDoc.${name}`)}</span>
        <span className="params-facts">
          {t("params.facts", {
            default: info.default,
            minimum: info.minimum,
            maximum: info.maximum,
            step: info.step,
          })}
        </span>
      </p>
    </div>
  );
}
