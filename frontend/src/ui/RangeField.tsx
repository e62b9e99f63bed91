import { useId } from "react";
import "./Field.css";
import "./RangeField.css";

interface Props {
  label: string;
  value: number;
  minimum: number;
  maximum: number;
  step: number;
  /** The value as text, shown beside the slider and read instead of the bare number. */
  text: string;
  onChange: (value: number) => void;
}

/**
 * A number on a horizontal slider, applied while it moves. For values that may change often: a volume, not a command.
 */
export function RangeField({ label, value, minimum, maximum, step, text, onChange }: Props) {
  const id = useId();
  return (
    <div className="ui-field ui-range">
      <label htmlFor={id} className="ui-field-label">
        {label}
      </label>
      <span className="ui-range-line">
        <input
          id={id}
          type="range"
          min={minimum}
          max={maximum}
          step={step}
          value={value}
          aria-valuetext={text}
          onChange={(event) => onChange(event.currentTarget.valueAsNumber)}
        />
        <span className="ui-range-text" aria-hidden="true">
          {text}
        </span>
      </span>
    </div>
  );
}
