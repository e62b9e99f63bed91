import { Plus } from "lucide-react";
import { useMemo, useState } from "react";
import { useTranslation } from "react-i18next";
import { FIELDS } from "../../protocol/messages.gen";
import { FIELD_KINDS } from "../../protocol/topics";
import { Button } from "../../ui/Button";
import { useRefuse } from "../../ui/refusal";
import { Select } from "../../ui/Select";
import { TextField } from "../../ui/TextField";
import { MOST_SIGNALS } from "./plotLayouts";
import { type Derivation, derivedName, shownName, shownUnit, signalLabel, unitSymbol } from "./signalNames";
import { useFeed } from "./usePlots";

interface Field {
  readonly name: string;
  readonly unit: string;
}

interface Group {
  readonly topic: string;
  readonly fields: readonly Field[];
}

interface Props {
  /** The signals of the chosen plot. */
  readonly chosen: readonly string[];
  readonly onAdd: (name: string) => void;
}

const UNITS: Readonly<Record<string, Readonly<Record<string, { readonly unit: string }>>>> = FIELDS;

/** All that the board can send: the choice before the flight's own topics are known. */
const DEFINED: readonly Group[] = [...FIELD_KINDS].map(([topic, fields]) => ({
  topic,
  fields: fields.map(([name]) => ({ name, unit: UNITS[topic]?.[name]?.unit ?? "1" })),
}));

/** The tree of topics and fields, with search; one press adds a signal to the chosen plot. */
export function SignalPicker({ chosen, onAdd }: Props) {
  const { t } = useTranslation();
  const refuse = useRefuse();
  const [search, setSearch] = useState("");
  const groups = useGroups();
  const wanted = search.trim().toLowerCase();
  const found = groups
    .map(({ topic, fields }) => ({
      topic,
      fields: fields.filter(({ name }) =>
        [name, shownName(name)].some((one) => `${topic}.${one}`.toLowerCase().includes(wanted)),
      ),
    }))
    .filter(({ fields }) => fields.length > 0);
  const count = found.reduce((sum, { fields }) => sum + fields.length, 0);
  const isFull = chosen.length >= MOST_SIGNALS;
  const fullReason = isFull ? t("plots.full", { count: MOST_SIGNALS }) : undefined;
  return (
    <section className="plots-picker" aria-label={t("plots.signals")}>
      <TextField label={t("plots.search")} value={search} onCommit={setSearch} onEdit={setSearch} />
      <p className="plots-found" role="status">
        {count === 0 ? t("plots.nothingFound") : t("plots.found", { count })}
      </p>
      <ul className="plots-tree">
        {found.map(({ topic, fields }) => (
          <li key={topic}>
            <details open={wanted !== "" || undefined}>
              <summary>{topic}</summary>
              <ul>
                {fields.map(({ name, unit }) => {
                  const signal = `${topic}.${name}`;
                  const isChosen = chosen.includes(signal);
                  return (
                    <li key={name}>
                      <button
                        type="button"
                        className="plots-field"
                        aria-label={t("plots.add", { name: signalLabel(signal) })}
                        aria-disabled={isChosen || isFull || undefined}
                        onClick={() => {
                          const reason = isChosen ? t("plots.isChosen") : fullReason;
                          reason === undefined ? onAdd(signal) : refuse(reason);
                        }}
                      >
                        <Plus aria-hidden="true" size={12} />
                        <span className="plots-name">{shownName(name)}</span>
                        <span className="plots-unit">{unitSymbol(shownUnit(unit).unit)}</span>
                      </button>
                    </li>
                  );
                })}
              </ul>
            </details>
          </li>
        ))}
      </ul>
      {fullReason !== undefined && <p className="plots-found">{fullReason}</p>}
      <DerivedSignal groups={groups} onAdd={onAdd} disabledReason={fullReason} />
    </section>
  );
}

function useGroups(): readonly Group[] {
  const topics = useFeed("feed", (state) => state.topics);
  return useMemo(
    () =>
      topics === null
        ? DEFINED
        : topics
            .map(({ name, fields }) => ({
              topic: name,
              fields: fields.filter(({ kind }) => kind !== "text"),
            }))
            .filter(({ fields }) => fields.length > 0),
    [topics],
  );
}

const DERIVATIONS: readonly Derivation[] = ["rate", "diff", "error"];

interface DerivedProps {
  readonly groups: readonly Group[];
  readonly onAdd: (name: string) => void;
  readonly disabledReason: string | undefined;
}

/** A signal that the gateway computes from one or two recorded ones. */
function DerivedSignal({ groups, onAdd, disabledReason }: DerivedProps) {
  const { t } = useTranslation();
  const [derivation, setDerivation] = useState<Derivation>("rate");
  const [one, setOne] = useState<string | null>(null);
  const [other, setOther] = useState<string | null>(null);
  const options = groups.flatMap(({ topic, fields }) =>
    fields.map(({ name }) => ({ value: `${topic}.${name}`, label: `${topic}.${name}` })),
  );
  const operands = derivation === "rate" ? [one] : [one, other];
  const known = operands.filter((name): name is string => name !== null);
  return (
    <fieldset className="plots-derive">
      <legend>{t("plots.derive")}</legend>
      <Select
        label={t("plots.derivation")}
        placeholder={t("plots.choose")}
        value={derivation}
        onChange={setDerivation}
        options={DERIVATIONS.map((value) => ({ value, label: t(`plots.${value}`) }))}
      />
      <Select
        label={t("plots.operandA")}
        placeholder={t("plots.choose")}
        value={one}
        onChange={setOne}
        options={options}
      />
      {derivation !== "rate" && (
        <Select
          label={t("plots.operandB")}
          placeholder={t("plots.choose")}
          value={other}
          onChange={setOther}
          options={options}
        />
      )}
      <Button
        onPress={() => onAdd(derivedName(derivation, known))}
        disabledReason={disabledReason ?? (known.length < operands.length ? t("plots.choose") : undefined)}
      >
        {t("plots.addDerived")}
      </Button>
    </fieldset>
  );
}
