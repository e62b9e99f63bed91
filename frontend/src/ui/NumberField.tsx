import { Minus, Plus } from "lucide-react";
import { useId, useRef } from "react";
import { NumberQuestion } from "./NumberQuestion";
import { StateMark } from "./StateMark";
import { Tooltip } from "./Tooltip";
import { type NumberEditing, useNumberEdit } from "./useNumberEdit";
import { commandWord, useWords } from "./words";
import "./Field.css";

/** Shown for an unknown number: cannot be taken for one. */
const DASHES = "\u2013\u2009\u2013\u2009\u2013";

interface Props extends NumberEditing {
  unit?: string | undefined;
  stateText?: string | undefined;
}

/**
 * A number field that sends a command. An edit is sent on Enter, on blur or by a step button; Escape cancels it, and
 * the wheel does nothing. A number out of range is refused with the range, not silently limited. A refused edit is
 * shown while the field has the focus; on blur the value is shown again.
 */
export function NumberField(props: Props) {
  const { label, value, unit, state = "idle", stateText, disabledReason } = props;
  const words = useWords();
  const inputId = useId();
  const noteId = useId();
  const input = useRef<HTMLInputElement>(null);
  const edit = useNumberEdit(props);
  const { complaint, isInvalid, canStep, question } = edit;

  const disabled = disabledReason !== undefined;
  // The outcome of an earlier number does not apply to the one that is typed, or was refused.
  const isOther = state !== "pending" && (edit.isEdited || complaint !== "");
  const mark = isOther ? "idle" : state;
  const outcome = isOther ? "" : (stateText ?? commandWord(words, state));
  const note = disabledReason ?? (complaint || outcome);

  return (
    <div className="ui-field" data-state={mark} data-edited={edit.isEdited}>
      <label htmlFor={inputId} className="ui-field-label">
        {label}
      </label>
      <span className="ui-field-box" data-invalid={isInvalid} data-disabled={disabled}>
        <StepButton
          label={`${words.decrease} ${label}`}
          down
          disabled={!canStep}
          onPress={() => edit.move(-1)}
        />
        <Tooltip text={note}>
          <input
            ref={input}
            id={inputId}
            className="ui-field-input ui-field-number"
            type="text"
            inputMode="decimal"
            autoComplete="off"
            spellCheck={false}
            value={edit.shown}
            placeholder={value === null ? DASHES : undefined}
            readOnly={disabled}
            aria-disabled={disabled || undefined}
            aria-invalid={isInvalid || undefined}
            aria-describedby={noteId}
            onChange={(event) => edit.type(event.currentTarget.value)}
            onBlur={edit.leave}
            onKeyDown={edit.onKeyDown}
          />
        </Tooltip>
        {unit !== undefined && <span className="ui-field-unit">{unit}</span>}
        <StateMark state={mark} />
        <StepButton label={`${words.increase} ${label}`} disabled={!canStep} onPress={() => edit.move(1)} />
      </span>
      <span id={noteId} className={complaint === "" ? "visually-hidden" : "ui-field-complaint"} role="status">
        {note}
      </span>
      {question !== null && (
        <NumberQuestion
          readings={question}
          unit={unit}
          onChoose={(value) => {
            input.current?.focus();
            edit.choose(value);
          }}
        />
      )}
    </div>
  );
}

interface StepButtonProps {
  label: string;
  disabled: boolean;
  onPress: () => void;
  down?: boolean;
}

/** Only for the pointer: the arrow keys in the field do the same. */
function StepButton({ label, disabled, onPress, down = false }: StepButtonProps) {
  return (
    <button
      type="button"
      className="ui-field-step"
      tabIndex={-1}
      aria-label={label}
      aria-disabled={disabled || undefined}
      // The press must not take the focus first: the blur would send the draft as well as the step.
      onMouseDown={(event) => event.preventDefault()}
      onClick={onPress}
    >
      {down ? <Minus size={14} /> : <Plus size={14} />}
    </button>
  );
}
