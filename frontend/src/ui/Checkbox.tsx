import { useId } from "react";
import { usePress } from "./refusal";
import { Tooltip } from "./Tooltip";
import "./Checkbox.css";

interface Props {
  label: string;
  checked: boolean;
  onChange: (checked: boolean) => void;
  disabledReason?: string | undefined;
}

/** A native checkbox: every keyboard and screen reader knows it. It takes effect at once. */
export function Checkbox({ label, checked, onChange, disabledReason }: Props) {
  const noteId = useId();
  const press = usePress(disabledReason);
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
            const { checked: asked } = event.currentTarget;
            press(() => onChange(asked));
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
