import { useState } from "react";
import { TextField } from "./TextField";

interface Props {
  label: string;
  /** "2026-01-31", or empty. */
  value: string;
  onChange: (day: string) => void;
  /** The form of a day, as the empty field shows it. */
  form: string;
}

/**
 * A day, typed year first: a native field would show it as the browser's country writes it, whatever the page's
 * language. It is taken as soon as it is a whole day, or empty.
 */
export function DateField({ label, value, onChange, form }: Props) {
  const [wrong, setWrong] = useState<string | null>(null);

  function edit(text: string): void {
    const day = text.trim();
    if (day !== value && (day === "" || isDay(day))) {
      onChange(day);
    }
  }

  return (
    <div className="ui-field-day">
      <TextField
        label={label}
        value={wrong ?? value}
        onEdit={(text) => {
          setWrong(null);
          edit(text);
        }}
        onCommit={(text) => {
          const day = text.trim();
          setWrong(day === "" || isDay(day) ? null : text);
          edit(text);
        }}
        placeholder={form}
        error={wrong === null ? undefined : form}
        monospace
      />
    </div>
  );
}

/** Whether this is a day of the calendar, as 2026-01-31. */
export function isDay(text: string): boolean {
  const at_ms = /^\d{4}-\d{2}-\d{2}$/.test(text) ? Date.parse(`${text}T00:00:00Z`) : Number.NaN;
  return Number.isFinite(at_ms) && new Date(at_ms).toISOString().startsWith(text);
}
