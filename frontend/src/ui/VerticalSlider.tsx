import { type ReactNode, useId } from "react";
import { usePress } from "./refusal";
import { StateMark } from "./StateMark";
import type { CommandState } from "./words";
import "./VerticalSlider.css";
import { commandWord, useWords } from "./words";

interface Props {
  /** Shown above the slider; short, because many are side by side. */
  label: string;
  /** Accessible name. */
  name: string;
  /** Its last position; null if it was never moved: then the thumb means no position. */
  value: number | null;
  minimum: number;
  maximum: number;
  step: number;
  /** The thumb's place without a value. */
  rest: number;
  /** Numbers in the reader's notation. */
  format: (value: number) => string;
  /** Read and shown instead of the number if there is none. */
  noValueText: string;
  onMove: (value: number) => void;
  /** The outcome of the newest move, with its message if any. */
  state: CommandState;
  stateText?: string | undefined;
  /** Why it is disabled. */
  disabledReason?: string | undefined;
  /** Id of the text that says why it is disabled. */
  describedBy?: string | undefined;
  /** Shown below the number: a button that belongs to this slider. */
  children?: ReactNode;
}

const DASHES = "\u2013\u2009\u2013";

/** A vertical slider: up is more. Every move is reported at once; the receiver limits the rate. */
export function VerticalSlider(props: Props) {
  const { label, name, value, minimum, maximum, step, rest, format, noValueText, onMove } = props;
  const { state, stateText, disabledReason, describedBy, children } = props;
  const disabled = disabledReason !== undefined;
  const press = usePress(disabledReason);
  const words = useWords();
  const noteId = useId();
  const outcome = stateText ?? commandWord(words, state);
  return (
    <div className="ui-vslider" data-known={value !== null} data-state={state}>
      <span className="ui-vslider-label" aria-hidden="true">
        {label}
      </span>
      <input
        className="ui-vslider-input"
        type="range"
        aria-orientation="vertical"
        aria-label={name}
        aria-valuetext={value === null ? noValueText : format(value)}
        aria-disabled={disabled || undefined}
        aria-describedby={disabled ? describedBy : noteId}
        min={minimum}
        max={maximum}
        step={step}
        value={value ?? rest}
        onChange={(event) => {
          const { valueAsNumber } = event.currentTarget;
          press(() => onMove(valueAsNumber));
        }}
      />
      <span className="ui-vslider-value" aria-hidden="true" title={outcome === "" ? undefined : outcome}>
        {value === null ? DASHES : format(value)}
        <StateMark state={state} />
      </span>
      <span id={noteId} className="visually-hidden">
        {outcome}
      </span>
      {children}
    </div>
  );
}
