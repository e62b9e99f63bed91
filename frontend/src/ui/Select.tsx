import { ChevronDown } from "lucide-react";
import { type SyntheticEvent, useId } from "react";
import { usePress } from "./refusal";
import { Tooltip } from "./Tooltip";
import "./Field.css";

export interface SelectOption<V extends string> {
  value: V;
  label: string;
}

interface Props<V extends string> {
  label: string;
  options: readonly SelectOption<V>[];
  value: V | null;
  onChange: (value: V) => void;
  /** Shown while nothing is chosen. */
  placeholder: string;
  disabledReason?: string | undefined;
  hideLabel?: boolean | undefined;
}

const OPENS: ReadonlySet<string> = new Set(["Enter", " ", "ArrowUp", "ArrowDown", "F4"]);

/** A native select: it works with every keyboard, screen reader and touch screen. */
export function Select<V extends string>(props: Props<V>) {
  const { label, options, value, onChange, placeholder, disabledReason, hideLabel } = props;
  const selectId = useId();
  const noteId = useId();
  const press = usePress(disabledReason);
  const disabled = disabledReason !== undefined;
  /** A press that would open the list of a disabled one. */
  function refuseOpening(event: SyntheticEvent): void {
    if (disabled) {
      event.preventDefault();
      press(() => undefined);
    }
  }

  return (
    <div className="ui-field">
      <label htmlFor={selectId} className={hideLabel === true ? "visually-hidden" : "ui-field-label"}>
        {label}
      </label>
      <Tooltip text={disabledReason ?? ""}>
        <span className="ui-field-box ui-field-choice" data-disabled={disabled}>
          <select
            id={selectId}
            className="ui-field-input ui-field-select"
            value={value ?? ""}
            aria-disabled={disabled || undefined}
            aria-describedby={disabled ? noteId : undefined}
            onMouseDown={refuseOpening}
            onKeyDown={(event) => OPENS.has(event.key) && refuseOpening(event)}
            onChange={(event) => {
              const chosen = options.find((option) => option.value === event.currentTarget.value);
              if (chosen !== undefined) press(() => onChange(chosen.value));
            }}
          >
            {value === null && (
              <option value="" disabled>
                {placeholder}
              </option>
            )}
            {options.map((option) => (
              <option key={option.value} value={option.value}>
                {option.label}
              </option>
            ))}
          </select>
          <ChevronDown size={14} aria-hidden="true" className="ui-field-chevron" />
        </span>
      </Tooltip>
      <span id={noteId} className="visually-hidden">
        {disabledReason}
      </span>
    </div>
  );
}
