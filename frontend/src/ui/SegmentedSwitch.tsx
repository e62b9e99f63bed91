import { type ReactNode, useId } from "react";
import { StateMark } from "./StateMark";
import type { CommandState } from "./states";
import { Tooltip } from "./Tooltip";
import { commandWord, useWords } from "./words";
import "./SegmentedSwitch.css";

export interface Segment<V extends string> {
  value: V;
  label: string;
  icon?: ReactNode;
}

interface Props<V extends string> {
  label: string;
  options: readonly Segment<V>[];
  /** The reported position; `null` without live data. */
  value: V | null;
  /** Requested and not yet proven. */
  wanted?: V | null | undefined;
  onChange: (value: V) => void;
  state?: CommandState | undefined;
  stateText?: string | undefined;
  disabledReason?: string | undefined;
  /** Show the name only to screen readers. */
  hideLabel?: boolean | undefined;
}

/**
 * A switch with two or a few positions. It shows the board's position, not the clicked one: until the proof comes,
 * the wanted position only pulses.
 */
export function SegmentedSwitch<V extends string>(props: Props<V>) {
  const {
    label,
    options,
    value,
    wanted = null,
    onChange,
    state = "idle",
    stateText,
    disabledReason,
    hideLabel,
  } = props;
  const words = useWords();
  const name = useId();
  const noteId = useId();
  const disabled = disabledReason !== undefined;
  const note = disabledReason ?? stateText ?? commandWord(words, state);
  const ask = (option: V): void => {
    if (!disabled) onChange(option);
  };
  return (
    <Tooltip text={note}>
      <fieldset
        className="ui-switch"
        data-state={state}
        data-known={value !== null}
        aria-describedby={note === "" ? undefined : noteId}
        aria-disabled={disabled || undefined}
      >
        <legend className={hideLabel === true ? "visually-hidden" : "ui-switch-label"}>{label}</legend>
        <span className="ui-switch-box">
          {options.map((option) => (
            <label key={option.value} className="ui-switch-option" data-wanted={wanted === option.value}>
              <input
                type="radio"
                className="visually-hidden"
                name={name}
                value={option.value}
                checked={value === option.value}
                aria-disabled={disabled || undefined}
                onChange={() => ask(option.value)}
                onClick={() => {
                  // Back again before the proof: the position is still the old one, so nothing changes here.
                  if (value === option.value && wanted !== null && wanted !== value) ask(option.value);
                }}
              />
              {option.icon}
              <span>{option.label}</span>
            </label>
          ))}
        </span>
        <StateMark state={state} />
        <span id={noteId} className="visually-hidden" role={disabled ? undefined : "status"}>
          {note}
        </span>
      </fieldset>
    </Tooltip>
  );
}
