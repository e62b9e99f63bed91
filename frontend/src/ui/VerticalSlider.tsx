import { type ReactNode, useId } from "react";
import { StateMark } from "./StateMark";
import type { CommandState } from "./states";
import "./VerticalSlider.css";
import { commandWord, useWords } from "./words";

interface Props {
  /** Shown over the slider; short, for many stand in a row. */
  label: string;
  /** Accessible name. */
  name: string;
  /** Where it was moved last; null while nobody has moved it, and then its thumb tells no position. */
  value: number | null;
  minimum: number;
  maximum: number;
  step: number;
  /** Where the thumb rests while there is no value. */
  rest: number;
  /** Numbers in the reader's notation. */
  format: (value: number) => string;
  /** Said and shown in the number's place while there is none. */
  noValueText: string;
  onMove: (value: number) => void;
  /** What became of the newest move, with its sentence where there is one. */
  state: CommandState;
  stateText?: string | undefined;
  disabled?: boolean | undefined;
  /** Id of the sentence that says why it is disabled. */
  describedBy?: string | undefined;
  /** Stands under the number: a button that belongs to this slider. */
  children?: ReactNode;
}

const DASHES = "\u2013\u2009\u2013";

/** A slider that stands upright: up is more. Every move is told at once; whoever hears it keeps the pace. */
export function VerticalSlider(props: Props) {
  const { label, name, value, minimum, maximum, step, rest, format, noValueText, onMove } = props;
  const { state, stateText, disabled = false, describedBy, children } = props;
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
          if (!disabled) {
            onMove(event.currentTarget.valueAsNumber);
          }
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
