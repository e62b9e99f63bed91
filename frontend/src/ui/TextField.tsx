import { type KeyboardEvent, useId, useState } from "react";
import { usePress } from "./refusal";
import { Tooltip } from "./Tooltip";
import "./Field.css";

interface Props {
  label: string;
  value: string;
  /** Called on Enter and on blur with a changed text; not per keystroke. */
  onCommit: (text: string) => void;
  /** Called for each keystroke, if the unfinished text is needed. */
  onEdit?: ((text: string) => void) | undefined;
  /** Called on Enter after the commit, even without an edit: to send a line. */
  onEnter?: ((text: string) => void) | undefined;
  placeholder?: string | undefined;
  /** What to enter. */
  hint?: string | undefined;
  /** What is wrong with the text. */
  error?: string | undefined;
  disabledReason?: string | undefined;
  /** For addresses, shell lines and other exact text. */
  monospace?: boolean | undefined;
  hideLabel?: boolean | undefined;
  /** A password: its characters are not shown. */
  secret?: boolean | undefined;
}

/** A line of text. Enter and blur finish an edit, Escape cancels it. */
export function TextField(props: Props) {
  const { label, value, onCommit, onEdit, onEnter, placeholder, hint, error, disabledReason } = props;
  const inputId = useId();
  const noteId = useId();
  const [draft, setDraft] = useState<string | null>(null);
  const press = usePress(disabledReason);
  const disabled = disabledReason !== undefined;
  const shown = draft ?? value;

  function edit(text: string | null): void {
    setDraft(text);
    onEdit?.(text ?? value);
  }

  function finish(): void {
    setDraft(null);
    if (draft !== null && draft !== value) {
      onCommit(draft);
    }
  }

  function onKeyDown(event: KeyboardEvent): void {
    if (event.key === "Enter") {
      press(() => {
        finish();
        onEnter?.(shown);
      });
    } else if (event.key === "Escape" && draft !== null) {
      edit(null);
    } else {
      return;
    }
    event.preventDefault();
  }

  return (
    <div className="ui-field">
      <label htmlFor={inputId} className={props.hideLabel === true ? "visually-hidden" : "ui-field-label"}>
        {label}
      </label>
      <Tooltip text={disabledReason ?? ""}>
        <input
          id={inputId}
          className={
            props.monospace === true
              ? "ui-field-input ui-field-line ui-field-exact"
              : "ui-field-input ui-field-line"
          }
          type={props.secret === true ? "password" : "text"}
          autoComplete={props.secret === true ? "new-password" : "off"}
          spellCheck={false}
          value={shown}
          placeholder={placeholder}
          readOnly={disabled}
          aria-disabled={disabled || undefined}
          aria-invalid={error !== undefined || undefined}
          aria-describedby={noteId}
          onChange={(event) => edit(event.currentTarget.value)}
          onBlur={finish}
          onKeyDown={onKeyDown}
        />
      </Tooltip>
      <span id={noteId} className={noteClass(error, disabledReason, hint)}>
        {error ?? disabledReason ?? hint}
      </span>
    </div>
  );
}

function noteClass(error?: string, disabledReason?: string, hint?: string): string {
  if (error !== undefined) return "ui-field-complaint";
  return disabledReason === undefined && hint !== undefined ? "ui-field-hint" : "visually-hidden";
}
