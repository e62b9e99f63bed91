import "./MessageLine.css";

interface Props {
  /** Read out before the text. */
  label: string;
  text: string;
  level?: "info" | "warning" | "error" | undefined;
  /** Its time, as text. */
  time?: string | undefined;
  className?: string | undefined;
}

/** The newest message in one line of the status bar; the whole text is in the tooltip. */
export function MessageLine({ label, text, level = "info", time, className }: Props) {
  return (
    <div
      className={className === undefined ? "ui-message" : `ui-message ${className}`}
      data-level={level}
      role="status"
      aria-label={label}
      title={text}
    >
      {time !== undefined && <span className="ui-message-time">{time}</span>}
      <span className="ui-message-text">{text}</span>
    </div>
  );
}
