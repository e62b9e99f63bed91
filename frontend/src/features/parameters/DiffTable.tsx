import { useTranslation } from "react-i18next";
import { StateMark } from "../../ui/StateMark";
import type { CommandState } from "../../ui/words";
import type { ParameterFault } from "./parameterFile";
import { gainsOf, stateOf, useParameters } from "./parameterValues";

/** One line of a change of several gains. `name` is null where it cannot be written, and `fault` says why. */
export interface DiffLine {
  readonly key: string;
  readonly name: string | null;
  /** The name as it was given. */
  readonly title: string;
  /** The value as it was given. */
  readonly text: string;
  readonly wanted: number | null;
  readonly fault: ParameterFault | null;
}

interface Props {
  lines: readonly DiffLine[];
  ticked: ReadonlySet<string>;
  /** What was written; null before. */
  written: ReadonlySet<string> | null;
  isWriting: boolean;
  onTick: (name: string, isTicked: boolean) => void;
}

/** The lines with what the board has now, a tick for each that would change, and what became of it. */
export function DiffTable({ lines, ticked, written, isWriting, onTick }: Props) {
  const { t } = useTranslation();
  return (
    <table className="params-table">
      <caption className="visually-hidden">{t("paramDiff.label")}</caption>
      <thead>
        <tr>
          <th scope="col">{t("paramDiff.write")}</th>
          <th scope="col">{t("paramDiff.parameter")}</th>
          <th scope="col">{t("paramDiff.now")}</th>
          <th scope="col">{t("paramDiff.then")}</th>
          <th scope="col">{t("paramDiff.result")}</th>
        </tr>
      </thead>
      <tbody>
        {lines.map((line) => (
          <Line
            key={line.key}
            line={line}
            isTicked={line.name !== null && ticked.has(line.name)}
            canTick={written === null}
            isWritten={line.name !== null && written?.has(line.name) === true}
            isWriting={isWriting}
            onTick={onTick}
          />
        ))}
      </tbody>
    </table>
  );
}

interface LineProps {
  line: DiffLine;
  isTicked: boolean;
  canTick: boolean;
  isWritten: boolean;
  isWriting: boolean;
  onTick: (name: string, isTicked: boolean) => void;
}

function Line({ line, isTicked, canTick, isWritten, isWriting, onTick }: LineProps) {
  const { t } = useTranslation();
  const values = useParameters((all) => all);
  const held = line.name === null ? null : stateOf(values, line.name);
  const { name } = line;
  const isSame = held !== null && held.value === line.wanted;
  const state = isWritten ? resultOf(held?.state, isWriting) : "idle";
  return (
    <tr data-fault={line.fault !== null} data-same={isSame && !isWritten}>
      <td>
        {name !== null && (!isSame || isWritten) && (
          <input
            type="checkbox"
            aria-label={t("paramDiff.tick", { name })}
            checked={isTicked}
            disabled={!canTick}
            onChange={(event) => onTick(name, event.currentTarget.checked)}
          />
        )}
      </td>
      <th scope="row">{line.title === "" ? t("words.dash") : line.title}</th>
      <td className="params-figure">{held?.value ?? t("words.dash")}</td>
      <td className="params-figure">{line.text}</td>
      <td>
        <span className="params-result">
          <StateMark state={state} />
          {resultText()}
        </span>
      </td>
    </tr>
  );

  function resultText(): string {
    if (line.fault !== null) {
      const info = gainsOf(values).find((known) => known.name === line.title);
      return t(`paramFault.${line.fault}`, {
        text: line.text,
        minimum: info?.minimum ?? "",
        maximum: info?.maximum ?? "",
      });
    }
    switch (state) {
      case "pending":
        return t("words.pending");
      case "confirmed":
        return t("words.confirmed");
      case "rejected":
        return t("paramDiff.refused", { value: held?.value ?? t("words.unknown") });
      case "timed_out":
        return t("paramDiff.lost");
      default:
        return t(isSame ? "paramDiff.same" : "paramDiff.waiting");
    }
  }
}

/** What became of a written line, as the gains say it after the read-back. */
function resultOf(state: string | undefined, isWriting: boolean): CommandState {
  if (isWriting) {
    return "pending";
  }
  return state === "confirmed" || state === "rejected" ? state : "timed_out";
}
