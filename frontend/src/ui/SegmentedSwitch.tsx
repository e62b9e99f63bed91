import { type ReactNode, useId } from "react";
import { usePress } from "./refusal";
import { StateMark } from "./StateMark";
import { Tooltip } from "./Tooltip";
import type { CommandState } from "./words";
import { commandWord, useWords } from "./words";
import "./SegmentedSwitch.css";

export interface Segment<V extends string> {
  value: V;
  label: string;
  icon?: ReactNode;
  /** Asked for at every press: also where the switch is disabled, or stands there already. */
  always?: boolean | undefined;
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
  const press = usePress(disabledReason);
  const disabled = disabledReason !== undefined;
  const note = disabledReason ?? stateText ?? commandWord(words, state);
  const ask = ({ value: asked, always = false }: Segment<V>): void =>
    always ? onChange(asked) : press(() => onChange(asked));
  // A press on the position where it stands changes nothing by itself: it is heard where it wants back before the
  // proof, and where it has an answer.
  const isAskedAgain = (option: Segment<V>): boolean =>
    value === option.value && (disabled || option.always === true || (wanted !== null && wanted !== value));
  return (
    <Tooltip text={note}>
      <fieldset
        className="ui-switch"
        data-state={state}
        data-known={value !== null}
        aria-describedby={note === "" ? undefined : noteId}
        data-disabled={disabled}
        // Said of the group it would be true of every position.
        aria-disabled={(disabled && !options.some(({ always }) => always === true)) || undefined}
      >
        <legend className={hideLabel === true ? "visually-hidden" : "ui-switch-label"}>{label}</legend>
        <span className="ui-switch-box">
          {options.map((option) => (
            <label
              key={option.value}
              className="ui-switch-option"
              data-wanted={wanted === option.value}
              data-disabled={disabled && option.always !== true}
            >
              <input
                type="radio"
                className="visually-hidden"
                name={name}
                value={option.value}
                checked={value === option.value}
                aria-disabled={(disabled && option.always !== true) || undefined}
                onChange={() => ask(option)}
                onClick={() => isAskedAgain(option) && ask(option)}
              />
              {option.icon}
              <span className="ui-switch-text" data-text={option.label}>
                {option.label}
              </span>
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
