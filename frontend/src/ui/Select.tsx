import { ChevronDown } from "lucide-react";
import { useId } from "react";
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

/** A native select: it works with every keyboard, screen reader and touch screen. */
export function Select<V extends string>(props: Props<V>) {
  const { label, options, value, onChange, placeholder, disabledReason, hideLabel } = props;
  const selectId = useId();
  const noteId = useId();
  const disabled = disabledReason !== undefined;
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
            disabled={disabled}
            aria-describedby={disabled ? noteId : undefined}
            onChange={(event) => {
              const chosen = options.find((option) => option.value === event.currentTarget.value);
              if (chosen !== undefined) onChange(chosen.value);
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
