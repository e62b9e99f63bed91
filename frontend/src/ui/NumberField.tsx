import { Minus, Plus } from "lucide-react";
import { type KeyboardEvent, useId, useState } from "react";
import { parseNumber, stepped } from "./number";
import { StateMark } from "./StateMark";
import type { CommandState } from "./states";
import { Tooltip } from "./Tooltip";
import { commandWord, useWords } from "./words";
import "./Field.css";

/** Shown for an unknown number: cannot be taken for one. */
const DASHES = "\u2013\u2009\u2013\u2009\u2013";

interface Props {
  label: string;
  /** The board's value; `null` is unknown. */
  value: number | null;
  /** Called once per finished edit, not per keystroke, and only with a number in the range. */
  onCommit: (value: number) => void;
  minimum: number;
  maximum: number;
  step: number;
  /** Numbers in the reader's notation. */
  format?: ((value: number) => string) | undefined;
  unit?: string | undefined;
  /** A further check besides the range: returns the complaint about a number, or null. */
  refuse?: ((value: number) => string | null) | undefined;
  state?: CommandState | undefined;
  stateText?: string | undefined;
  disabledReason?: string | undefined;
}

/**
 * A number field that sends a command. An edit is sent on Enter, on blur or by a step button; Escape cancels it, and
 * the wheel does nothing. A number out of range is refused with the range, not silently limited.
 */
export function NumberField(props: Props) {
  const { label, value, onCommit, minimum, maximum, step, format = String, unit } = props;
  const { state = "idle", stateText, disabledReason, refuse } = props;
  const words = useWords();
  const inputId = useId();
  const noteId = useId();
  const [draft, setDraft] = useState<string | null>(null);
  const [asked, setAsked] = useState<number | null>(null);
  const [complaint, setComplaint] = useState("");

  const disabled = disabledReason !== undefined;
  // Until the board answers, show the requested value, marked as pending.
  const held = state === "pending" && asked !== null ? asked : value;
  const shown = draft ?? (held === null ? "" : format(held));
  const note = disabledReason ?? (complaint === "" ? (stateText ?? commandWord(words, state)) : complaint);

  function forget(): void {
    setDraft(null);
    setComplaint("");
  }

  function send(next: number): void {
    forget();
    if (next !== held) {
      setAsked(next);
      onCommit(next);
    }
  }

  function finish(): void {
    if (draft === null) return;
    const typed = parseNumber(draft);
    if (draft.trim() === "") {
      forget();
    } else if (typed === null) {
      setComplaint(words.notANumber);
    } else if (typed < minimum || typed > maximum) {
      setComplaint(words.outOfRange(format(minimum), format(maximum)));
    } else {
      const refusal = refuse?.(typed) ?? null;
      if (refusal === null) send(typed);
      else setComplaint(refusal);
    }
  }

  // A step needs a known number: from an unknown one it would jump to the end of the range.
  const from = (draft === null ? null : parseNumber(draft)) ?? held;
  const canStep = !disabled && from !== null;

  function move(direction: 1 | -1): void {
    if (canStep) send(stepped(from, step, direction, minimum, maximum));
  }

  function onKeyDown(event: KeyboardEvent): void {
    if (event.key === "Enter") finish();
    else if (event.key === "Escape") forget();
    else if (event.key === "ArrowUp") move(1);
    else if (event.key === "ArrowDown") move(-1);
    else return;
    event.preventDefault();
  }

  return (
    <div className="ui-field" data-state={state} data-edited={draft !== null}>
      <label htmlFor={inputId} className="ui-field-label">
        {label}
      </label>
      <span className="ui-field-frame" data-invalid={complaint !== ""} data-disabled={disabled}>
        <StepButton label={`${words.decrease} ${label}`} down disabled={!canStep} onPress={() => move(-1)} />
        <Tooltip text={note}>
          <input
            id={inputId}
            className="ui-field-input ui-field-number"
            type="text"
            inputMode="decimal"
            autoComplete="off"
            spellCheck={false}
            value={shown}
            placeholder={value === null ? DASHES : undefined}
            readOnly={disabled}
            aria-disabled={disabled || undefined}
            aria-invalid={complaint !== "" || undefined}
            aria-describedby={noteId}
            onChange={(event) => {
              setDraft(event.currentTarget.value);
              setComplaint("");
            }}
            onBlur={finish}
            onKeyDown={onKeyDown}
          />
        </Tooltip>
        {unit !== undefined && <span className="ui-field-unit">{unit}</span>}
        <StateMark state={state} />
        <StepButton label={`${words.increase} ${label}`} disabled={!canStep} onPress={() => move(1)} />
      </span>
      <span id={noteId} className={complaint === "" ? "visually-hidden" : "ui-field-complaint"} role="status">
        {note}
      </span>
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
