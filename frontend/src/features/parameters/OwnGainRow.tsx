import { RotateCcw } from "lucide-react";
import { useTranslation } from "react-i18next";
import { formatClock } from "../../lib/moment";
import type { OwnGainDefinition, OwnGainState } from "../../protocol/guards.gen";
import { useBoardBlocked } from "../../requests/useBlocked";
import { usePart } from "../../store/hooks";
import { Button } from "../../ui/Button";
import { GainField } from "./GainField";
import { GainMarks } from "./GainMarks";
import { OwnChoiceField } from "./OwnChoiceField";
import { PARAMETER_REQUESTS, useParameters } from "./parameterValues";

const UNKNOWN: OwnGainState = { value: null, loaded: null, state: "unknown", heard_s: null };

/** One of the board's own gains with its range, its default, and what the board says that it does. */
export function OwnGainRow({ gain }: { gain: OwnGainDefinition }) {
  const { t } = useTranslation();
  const parameters = usePart(PARAMETER_REQUESTS);
  const held = useParameters(({ own }) => own.values[gain.name]) ?? UNKNOWN;
  const isSure = useParameters(({ own }) => own.table.state === "known");
  const blocked = useBoardBlocked() ?? (isSure ? undefined : t("ownGains.wait"));
  const { name, unit, minimum, maximum, step } = gain;
  const choices = gain.type === "flag" ? [t("ownGains.off"), t("ownGains.on")] : gain.choices;
  const isChoice = choices.length > 0;
  const say = (value: number): string | number => choices[value] ?? value;
  const write = (value: number): void => void parameters.edit(name, value);
  return (
    <div className="params-row" data-parameter={name}>
      {isChoice ? (
        <OwnChoiceField name={name} choices={choices} held={held} onCommit={write} disabledReason={blocked} />
      ) : (
        <GainField
          name={name}
          unit={unit}
          limits={{ minimum, maximum, step, isInteger: gain.type !== "f32" }}
          held={held}
          onCommit={write}
          disabledReason={blocked}
        />
      )}
      <GainMarks held={held} standard={gain.default} say={say} />
      {!isChoice && (
        <div className="params-actions">
          <Button
            onPress={() => write(gain.default)}
            icon={<RotateCcw aria-hidden="true" size={14} />}
            label={t("params.resetOne", { name })}
            disabledReason={blocked ?? (held.value === gain.default ? t("params.isDefault") : undefined)}
          >
            {null}
          </Button>
        </div>
      )}
      <p className="params-doc">
        {/* The board's own words. */}
        <span lang="en">{gain.doc}</span>
        <span className="params-facts">
          {isChoice
            ? t("ownGains.choiceFacts", { default: say(gain.default) })
            : t("params.facts", { default: gain.default, minimum, maximum, step })}
          {gain.needs_restart && ` · ${t("ownGains.needsRestart")}`}
          {held.heard_s !== null && ` · ${t("ownGains.heardAt", { time: formatClock(held.heard_s) })}`}
        </span>
      </p>
    </div>
  );
}
