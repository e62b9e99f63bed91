import { useId } from "react";
import { Tooltip } from "./Tooltip";
import "./Checkbox.css";

interface Props {
  label: string;
  checked: boolean;
  onChange: (checked: boolean) => void;
  disabledReason?: string | undefined;
}

/** Yes or no, at once. The browser's own box: it is the one that every keyboard and screen reader knows. */
export function Checkbox({ label, checked, onChange, disabledReason }: Props) {
  const noteId = useId();
  const disabled = disabledReason !== undefined;
  return (
    <Tooltip text={disabledReason ?? ""}>
      <label className="ui-checkbox" data-disabled={disabled}>
        <input
          type="checkbox"
          checked={checked}
          aria-disabled={disabled || undefined}
          aria-describedby={disabled ? noteId : undefined}
          onChange={(event) => {
            if (!disabled) onChange(event.currentTarget.checked);
          }}
        />
        <span>{label}</span>
        <span id={noteId} className="visually-hidden">
          {disabledReason}
        </span>
      </label>
    </Tooltip>
  );
}
