import { ScrollText } from "lucide-react";
import "./MessageLine.css";

interface Props {
  /** Read out before the text. */
  label: string;
  text: string;
  level?: "info" | "warning" | "error" | undefined;
  /** Its time, as text. */
  time?: string | undefined;
  /** What a press opens. */
  action?: { readonly label: string; readonly onPress: () => void } | undefined;
  className?: string | undefined;
}

/**
 * The newest message in one line of the status bar; the whole text is in the tooltip. The way to all of them stands before
 * it, where neither its length nor what is beside it moves it.
 */
export function MessageLine({ label, text, level = "info", time, action, className }: Props) {
  return (
    <div className={className === undefined ? "ui-message-row" : `ui-message-row ${className}`}>
      {action !== undefined && (
        <button
          type="button"
          className="ui-message-open"
          aria-label={action.label}
          title={action.label}
          onClick={action.onPress}
        >
          <ScrollText size={14} aria-hidden="true" />
        </button>
      )}
      <div className="ui-message" data-level={level} role="status" aria-label={label} title={text}>
        {time !== undefined && <span className="ui-message-time">{time}</span>}
        <span className="ui-message-text">{text}</span>
      </div>
    </div>
  );
}
