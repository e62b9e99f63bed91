import { type ReactNode, useId } from "react";
import { useEditsBlocked } from "./openEdits";
import { usePress } from "./refusal";
import { StateMark } from "./StateMark";
import { Tooltip } from "./Tooltip";
import type { CommandState } from "./words";
import { commandWord, useWords } from "./words";
import "./Button.css";

interface Props {
  children: ReactNode;
  onPress: () => void;
  variant?: "plain" | "primary" | "danger" | undefined;
  /** The outcome of the last click. */
  state?: CommandState | undefined;
  /** More than the state's word: the reason of a refusal. */
  stateText?: string | undefined;
  /** Why it is disabled. It stays in the tab order, and answers a press with the reason. */
  disabledReason?: string | undefined;
  icon?: ReactNode;
  /** For a button that is on or off. */
  pressed?: boolean | undefined;
  /** Accessible name, for a button with only an icon. */
  label?: string | undefined;
  type?: "button" | "submit" | undefined;
  /** It acts on the fields of its form: not while the last edit of one of them was not taken. */
  takesFields?: boolean | undefined;
}

/** A button that shows the outcome of its click, and why it is disabled. */
export function Button(props: Props) {
  const { children, onPress, variant = "plain", state = "idle", stateText } = props;
  const { icon, pressed, label, type = "button", takesFields = false } = props;
  const words = useWords();
  const openEdit = useEditsBlocked();
  const disabledReason = props.disabledReason ?? (takesFields ? openEdit : undefined);
  const noteId = useId();
  const press = usePress(disabledReason);
  const disabled = disabledReason !== undefined;
  const outcome = stateText ?? commandWord(words, state);
  const note = disabledReason ?? outcome;
  return (
    <>
      <Tooltip text={note}>
        <button
          type={type}
          className="ui-button"
          data-variant={variant}
          data-state={state}
          aria-label={label}
          aria-pressed={pressed}
          aria-disabled={disabled || undefined}
          aria-describedby={note === "" ? undefined : noteId}
          onClick={(event) => {
            if (disabled) {
              // A submit button must not submit its form either.
              event.preventDefault();
            }
            press(onPress);
          }}
        >
          {icon}
          <span className="ui-button-text">{children}</span>
          <StateMark state={state} />
        </button>
      </Tooltip>
      <span id={noteId} className="visually-hidden" role={disabled ? undefined : "status"}>
        {note}
      </span>
    </>
  );
}
