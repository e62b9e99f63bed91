import "./MessageLine.css";

interface Props {
  /** Read out before the text. */
  label: string;
  text: string;
  level?: "info" | "warning" | "error" | undefined;
  /** Its time, as text. */
  time?: string | undefined;
}

/** The newest message in one line of the status bar; the whole text is in the tooltip. */
export function MessageLine({ label, text, level = "info", time }: Props) {
  return (
    <div className="ui-message" data-level={level} role="status" aria-label={label} title={text}>
      {time !== undefined && <span className="ui-message-time">{time}</span>}
      <span className="ui-message-text">{text}</span>
    </div>
  );
}
