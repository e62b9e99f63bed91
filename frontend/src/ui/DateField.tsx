import { useId } from "react";
import "./Field.css";

interface Props {
  label: string;
  /** "2026-01-31", or empty. */
  value: string;
  onChange: (day: string) => void;
}

/** A native field for a day: it shows the day as the browser's country writes it, and opens its calendar. */
export function DateField({ label, value, onChange }: Props) {
  const id = useId();
  return (
    <div className="ui-field">
      <label htmlFor={id} className="ui-field-label">
        {label}
      </label>
      <input
        id={id}
        type="date"
        className="ui-field-input ui-field-line"
        value={value}
        onChange={(event) => onChange(event.currentTarget.value)}
      />
    </div>
  );
}
