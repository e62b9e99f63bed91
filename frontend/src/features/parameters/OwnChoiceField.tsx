import { useState } from "react";
import { useTranslation } from "react-i18next";
import { isFlownByAutopilot } from "../../missions/planFacts";
import type { OwnGainState } from "../../protocol/guards.gen";
import { usePage } from "../../store/hooks";
import { ConfirmDialog } from "../../ui/ConfirmDialog";
import { Select } from "../../ui/Select";
import { StateMark } from "../../ui/StateMark";
import { commandWord, useWords } from "../../ui/words";
import { useGainOutcome } from "./GainField";

interface Props {
  name: string;
  /** Texts of the values, in order from 0. */
  choices: readonly string[];
  held: OwnGainState;
  onCommit: (value: number) => void;
  disabledReason: string | undefined;
}

/**
 * A choice that the board offers, such as that of its guidance law. While an autopilot flies, it asks first: what steers
 * the aircraft may change at once.
 */
export function OwnChoiceField({ name, choices, held, onCommit, disabledReason }: Props) {
  const { t } = useTranslation();
  const words = useWords();
  const { telemetry } = usePage();
  const [asked, setAsked] = useState<number | null>(null);
  const now = held.value === null ? null : (choices[held.value] ?? null);
  const { state, stateText } = useGainOutcome(name, held, now);
  const flies = (): boolean =>
    isFlownByAutopilot(telemetry, "hil") || isFlownByAutopilot(telemetry, "flight");

  function choose(text: string): void {
    const value = choices.indexOf(text);
    if (value === held.value) {
      return;
    }
    if (flies()) {
      setAsked(value);
    } else {
      onCommit(value);
    }
  }

  return (
    <>
      <Select
        label={name}
        options={choices.map((text) => ({ value: text, label: text }))}
        value={now}
        onChange={choose}
        placeholder="– – –"
        disabledReason={disabledReason}
      />
      <span className="params-outcome" role="status">
        <StateMark state={state} />
        {stateText ?? commandWord(words, state)}
      </span>
      {asked !== null && (
        <ConfirmDialog
          title={t("ownGains.askTitle", { name })}
          text={t("ownGains.askText", {
            name,
            before: now ?? t("words.unknown"),
            after: choices[asked] ?? "",
          })}
          confirmLabel={t("ownGains.askConfirm", { after: choices[asked] ?? "" })}
          cancelLabel={t("dialog.cancel")}
          danger
          onConfirm={() => {
            setAsked(null);
            onCommit(asked);
          }}
          onCancel={() => setAsked(null)}
        />
      )}
    </>
  );
}
