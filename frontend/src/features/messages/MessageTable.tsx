import { ChartLine, ChevronDown, ChevronRight } from "lucide-react";
import { Fragment, useState } from "react";
import { useTranslation } from "react-i18next";
import { formatAge, formatFixed } from "../../lib/format";
import { Button } from "../../ui/Button";
import type { Line, LineValue } from "./lines";
import { MOST_PLOTTED, type PlotKeyText } from "./plotted";

/** Those with numbers. */
const COLUMNS = ["rate", "jitter", "count", "damaged", "age"] as const;

interface PlotToggle {
  plotted: readonly PlotKeyText[];
  onToggle: (key: PlotKeyText) => void;
}

interface Props extends PlotToggle {
  label: string;
  lines: readonly Line[];
  /** The board's frames can be damaged; the simulator's rows cannot. */
  hasDamage?: boolean;
}

/** The message types with their rates; each row opens to show its last values. */
export function MessageTable({ label, lines, hasDamage = false, plotted, onToggle }: Props) {
  const { t } = useTranslation();
  const [open, setOpen] = useState<string | null>(null);
  const columns = hasDamage ? 7 : 6;
  return (
    <section
      className="messages-scroll"
      aria-label={label}
      // biome-ignore lint/a11y/noNoninteractiveTabindex: the keyboard must be able to scroll it
      tabIndex={0}
    >
      <table className="messages-table">
        <thead>
          <tr>
            <th scope="col">{t("messages.id")}</th>
            <th scope="col">{t("messages.name")}</th>
            {COLUMNS.filter((column) => hasDamage || column !== "damaged").map((column) => (
              <th key={column} scope="col" className="messages-number">
                {t(`messages.${column}`)}
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          {lines.map((line) => (
            <Fragment key={line.key}>
              <LineRow
                line={line}
                hasDamage={hasDamage}
                isOpen={open === line.key}
                onOpen={() => setOpen(open === line.key ? null : line.key)}
              />
              {open === line.key && (
                <tr className="messages-values">
                  <td colSpan={columns}>
                    <Values line={line} plotted={plotted} onToggle={onToggle} />
                  </td>
                </tr>
              )}
            </Fragment>
          ))}
        </tbody>
      </table>
    </section>
  );
}

interface RowProps {
  line: Line;
  hasDamage: boolean;
  isOpen: boolean;
  onOpen: () => void;
}

function LineRow({ line, hasDamage, isOpen, onOpen }: RowProps) {
  const { t } = useTranslation();
  const { state, age_s } = line;
  const word = { live: "", stale: t("words.stale"), none: t("messages.never") }[state];
  return (
    <tr data-state={state}>
      <td className="messages-id">{line.id}</td>
      <th scope="row">
        <button type="button" className="messages-open" aria-expanded={isOpen} onClick={onOpen}>
          {isOpen ? (
            <ChevronDown size={14} aria-hidden="true" />
          ) : (
            <ChevronRight size={14} aria-hidden="true" />
          )}
          {line.name}
        </button>
        {line.isNeeded && <span className="messages-needed">{t("messages.needed")}</span>}
      </th>
      <td className="messages-number">{formatFixed(line.rate_hz, 1)}</td>
      <td className="messages-number">{formatFixed(line.jitter_ms, 1) ?? t("words.dash")}</td>
      <td className="messages-number">{line.count}</td>
      {hasDamage && (
        <td className="messages-number" data-damaged={line.damaged > 0}>
          {line.damaged}
        </td>
      )}
      <td className="messages-number messages-age">
        {age_s === null ? word : formatAge(age_s)}
        {state === "stale" && <span className="visually-hidden">{word}</span>}
      </td>
    </tr>
  );
}

function Values({ line, plotted, onToggle }: PlotToggle & { line: Line }) {
  const { t } = useTranslation();
  if (line.values.length === 0) {
    return <p className="messages-none">{t("messages.noValues")}</p>;
  }
  return (
    <ul className="messages-value-list" data-state={line.state}>
      {line.values.map((value) => (
        <li key={value.name}>
          <span className="messages-value-name">{value.name}</span>
          <Text value={value} />
          {value.plotKey !== null && (
            <PlotButton name={value.name} plotKey={value.plotKey} plotted={plotted} onToggle={onToggle} />
          )}
        </li>
      ))}
    </ul>
  );
}

function Text({ value: { value, unit } }: { value: LineValue }) {
  const { t } = useTranslation();
  const text = typeof value === "boolean" ? t(value ? "words.on" : "words.off") : value;
  return (
    <span className="messages-value">
      {text ?? <span className="messages-none">{t("words.noData")}</span>}
      {text !== null && unit !== "" && <span className="messages-unit">{unit}</span>}
    </span>
  );
}

function PlotButton({
  name,
  plotKey,
  plotted,
  onToggle,
}: PlotToggle & { name: string; plotKey: PlotKeyText }) {
  const { t } = useTranslation();
  const isPlotted = plotted.includes(plotKey);
  return (
    <Button
      onPress={() => onToggle(plotKey)}
      pressed={isPlotted}
      label={t("messages.draw", { name })}
      disabledReason={
        !isPlotted && plotted.length >= MOST_PLOTTED
          ? t("messages.enough", { most: MOST_PLOTTED })
          : undefined
      }
      icon={<ChartLine size={14} aria-hidden="true" />}
    >
      {null}
    </Button>
  );
}
