import { useId, useState } from "react";
import { useTranslation } from "react-i18next";
import type { FaultChoice } from "../../protocol/guards.gen";
import { useAsked } from "../../requests/useAsked";
import { usePart } from "../../store/hooks";
import { Button } from "../../ui/Button";
import { Checkbox } from "../../ui/Checkbox";
import { NumberField } from "../../ui/NumberField";
import { TextField } from "../../ui/TextField";
import { BEGIN, FAULTS } from "./faultRequests";
import { askedStrength, faultName, grouped, shownStrength, shownUnit } from "./faultWords";

const USUAL_LENGTH_S = 20;
const LATEST_S = 3600;
const LONGEST_S = 86_400;
const ROWS = 8;

/** What was chosen of a fault; null: as usual for it. */
interface Draft {
  readonly strength: number | null;
  readonly length_s: number;
  readonly isUntilEnded: boolean;
}

function draftOf(choice: FaultChoice): Draft {
  return {
    strength: null,
    length_s: choice.usual_s ?? USUAL_LENGTH_S,
    isUntilEnded: choice.usual_s === null,
  };
}

/** Chooses a fault, its strength, when it begins and how long it lasts. */
export function NewFault({ choices }: { readonly choices: readonly FaultChoice[] }) {
  const { t } = useTranslation();
  const [search, setSearch] = useState("");
  const [chosen, setChosen] = useState<FaultChoice | null>(null);
  return (
    <div className="faults-new">
      <div className="faults-choose">
        <TextField label={t("faults.search")} value={search} onCommit={setSearch} onEdit={setSearch} />
        <FaultList choices={choices} search={search} chosen={chosen} onChoose={setChosen} />
      </div>
      {chosen === null ? (
        <p className="faults-hint">{t("faults.chooseFirst")}</p>
      ) : (
        <FaultForm key={`${chosen.place}.${chosen.kind}`} choice={chosen} />
      )}
    </div>
  );
}

interface ListProps {
  readonly choices: readonly FaultChoice[];
  readonly search: string;
  readonly chosen: FaultChoice | null;
  readonly onChoose: (choice: FaultChoice) => void;
}

/** A native list with groups: it works with every keyboard, screen reader and touch screen. */
function FaultList({ choices, search, chosen, onChoose }: ListProps) {
  const { t } = useTranslation();
  const id = useId();
  const groups = grouped(t, choices, search);
  return (
    <div className="ui-field">
      <label htmlFor={id} className="ui-field-label">
        {t("faults.which")}
      </label>
      <select
        id={id}
        className="faults-list"
        size={ROWS}
        value={chosen === null ? "" : nameOf(chosen)}
        onChange={({ currentTarget }) => {
          const found = choices.find((choice) => nameOf(choice) === currentTarget.value);
          if (found !== undefined) onChoose(found);
        }}
      >
        {groups.size === 0 && <option disabled>{t("faults.noneFound")}</option>}
        {[...groups].map(([place, kinds]) => (
          <optgroup key={place} label={t(`faultPlace.${place}`)}>
            {kinds.map((choice) => (
              <option key={choice.kind} value={nameOf(choice)}>
                {faultName(t, choice)}
              </option>
            ))}
          </optgroup>
        ))}
      </select>
    </div>
  );
}

function nameOf({ place, kind }: FaultChoice): string {
  return `${place}.${kind}`;
}

function FaultForm({ choice }: { readonly choice: FaultChoice }) {
  const { t } = useTranslation();
  const { begin } = usePart(FAULTS);
  const { state, stateText } = useAsked(BEGIN);
  const [draft, setDraft] = useState(() => draftOf(choice));
  const [start_s, setStart] = useState(0);
  const { place, kind, unit, usual, lowest, highest } = choice;
  const shown = shownUnit(unit);
  const most = shownStrength(highest, unit);
  const least = shownStrength(lowest, unit);
  return (
    <div className="faults-form">
      <p className="faults-name">{faultName(t, choice)}</p>
      {shown !== null && (
        <NumberField
          label={t("faults.strength")}
          value={draft.strength ?? shownStrength(usual, unit)}
          onCommit={(strength) => setDraft((before) => ({ ...before, strength }))}
          minimum={least}
          maximum={most}
          step={(most - least) / 100}
          format={(value) => String(Number(value.toPrecision(3)))}
          unit={t(`faultUnit.${shown.word}`)}
        />
      )}
      <NumberField
        label={t("faults.start")}
        value={start_s}
        onCommit={setStart}
        minimum={0}
        maximum={LATEST_S}
        step={5}
        unit={t("unit.s")}
      />
      <NumberField
        label={t("faults.length")}
        value={draft.length_s}
        onCommit={(length_s) => setDraft((before) => ({ ...before, length_s, isUntilEnded: false }))}
        minimum={0.1}
        maximum={LONGEST_S}
        step={5}
        unit={t("unit.s")}
        disabledReason={draft.isUntilEnded ? t("faults.untilEnded") : undefined}
      />
      <Checkbox
        label={t("faults.untilEnded")}
        checked={draft.isUntilEnded}
        onChange={(isUntilEnded) => setDraft((before) => ({ ...before, isUntilEnded }))}
      />
      <Button
        takesFields
        variant="primary"
        onPress={() =>
          void begin({
            place,
            kind,
            start_s,
            length_s: draft.isUntilEnded ? (choice.usual_s === null ? null : LONGEST_S) : draft.length_s,
            strength: draft.strength === null ? null : askedStrength(draft.strength, choice),
          })
        }
        state={state}
        stateText={stateText}
      >
        {t("faults.begin")}
      </Button>
    </div>
  );
}
