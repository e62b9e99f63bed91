import { type KeyboardEvent, useRef } from "react";
import { NumberQuestion } from "../../ui/NumberQuestion";
import { type NumberEdit, useNumberEdit } from "../../ui/useNumberEdit";

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

/**
 * A number in the plan's table, typed as in every number field: Enter and blur finish an edit, Escape cancels it. One
 * outside the board's range is taken, because the plan's faults say so of every number in it.
 */
export function PlanCell(props: Props) {
  const { label, text, row, field, isReadOnly, largest, fault, onCommit, onMove, onFocus } = props;
  const input = useRef<HTMLInputElement>(null);
  const edit = useNumberEdit({
    label,
    value: text === "" ? null : Number(text),
    minimum: -largest,
    maximum: largest,
    step: 1,
    format: () => text,
    onCommit,
    subject: text,
  });
  const { complaint, question } = edit;

  return (
    <>
      <input
        ref={input}
        className="plans-input"
        type="text"
        inputMode="decimal"
        autoComplete="off"
        spellCheck={false}
        readOnly={isReadOnly}
        aria-label={label}
        aria-invalid={complaint !== "" || fault !== null || undefined}
        title={complaint || (fault ?? undefined)}
        data-row={row}
        data-field={field}
        data-edited={edit.isEdited}
        value={edit.shown}
        onChange={(event) => edit.type(event.currentTarget.value)}
        onFocus={onFocus}
        onBlur={edit.leave}
        onKeyDown={(event) => onCellKey(event, edit, onMove)}
      />
      {complaint !== "" && (
        <span className="plans-complaint" role="status">
          {complaint}
        </span>
      )}
      {question !== null && (
        <NumberQuestion
          readings={question}
          onChoose={(value) => {
            input.current?.focus();
            edit.choose(value);
          }}
        />
      )}
    </>
  );
}

function onCellKey(event: KeyboardEvent, edit: NumberEdit, onMove: Props["onMove"]): void {
  const by = MOVES[event.key];
  if (event.altKey) {
    // The table's own keys: finish the edit of this row before it moves. A refused edit stays with its row.
    if (!edit.finish()) event.stopPropagation();
  } else if (event.ctrlKey || event.metaKey) {
    return;
  } else if (by !== undefined) {
    event.preventDefault();
    if (edit.finish() || !edit.isEdited) onMove(by);
  } else if (event.key === "Escape" || event.key === "Tab") {
    edit.onKeyDown(event);
  }
}
