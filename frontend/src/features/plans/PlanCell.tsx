import { type KeyboardEvent, useState } from "react";
import { useTranslation } from "react-i18next";
import { parseNumber, twoReadings } from "../../ui/number";
import { useWords } from "../../ui/words";

interface Props {
  label: string;
  /** The number as text, in the user's unit. */
  text: string;
  row: number;
  field: string;
  isReadOnly: boolean;
  /** No number of this column is larger, in the user's unit. */
  largest: number;
  /** Why this number is invalid; null if it is valid. */
  fault: string | null;
  /** A finished edit, in the user's unit; not called if the number is unchanged. */
  onCommit: (shown: number) => void;
  /** Move to the next or previous cell of the column. */
  onMove: (by: -1 | 1) => void;
  onFocus: () => void;
}

const MOVES: Readonly<Record<string, -1 | 1>> = { ArrowUp: -1, ArrowDown: 1, Enter: 1 };

/** A number in the plan's table. Enter and blur finish an edit, Escape cancels it. */
export function PlanCell({
  label,
  text,
  row,
  field,
  isReadOnly,
  largest,
  fault,
  onCommit,
  onMove,
  onFocus,
}: Props) {
  const { t } = useTranslation();
  const words = useWords();
  const [draft, setDraft] = useState<string | null>(null);
  const typed = draft === null ? null : parseNumber(draft);
  const readings = draft === null || draft === text ? null : twoReadings(draft, -largest, largest);
  const isNoNumber = draft !== null && draft.trim() !== "" && (typed === null || readings !== null);

  function finish(): void {
    setDraft(null);
    if (typed !== null && readings === null && draft !== text && typed !== Number(text)) {
      onCommit(typed);
    }
  }

  function onKeyDown(event: KeyboardEvent): void {
    const by = MOVES[event.key];
    if (event.altKey || event.ctrlKey || event.metaKey) {
      // The table's own keys: finish the edit of this row before it moves.
      if (event.altKey && !isNoNumber) finish();
    } else if (event.key === "Escape") {
      setDraft(null);
      event.preventDefault();
    } else if (by !== undefined) {
      event.preventDefault();
      if (!isNoNumber) {
        finish();
        onMove(by);
      }
    }
  }

  const question =
    readings === null ? t("plans.notANumber") : words.whichNumber(readings.thousand, readings.one);
  const complaint = isNoNumber ? question : fault;
  return (
    <input
      className="plans-input"
      type="text"
      inputMode="decimal"
      autoComplete="off"
      spellCheck={false}
      readOnly={isReadOnly}
      aria-label={label}
      aria-invalid={complaint !== null || undefined}
      title={complaint ?? undefined}
      data-row={row}
      data-field={field}
      data-edited={draft !== null}
      value={draft ?? text}
      onChange={(event) => setDraft(event.currentTarget.value)}
      onFocus={onFocus}
      onBlur={finish}
      onKeyDown={onKeyDown}
    />
  );
}
