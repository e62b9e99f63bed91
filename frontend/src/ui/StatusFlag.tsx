import "./StatusFlag.css";
import { useWords } from "./words";

interface Props {
  label: string;
  /** `null`: the board has not reported it. */
  value: boolean | null;
  /** The last report is old. */
  stale?: boolean | undefined;
  /** Words other than on and off, for a flag with another meaning. */
  texts?: { on: string; off: string } | undefined;
}

/** A lamp with its name and its state in words. */
export function StatusFlag({ label, value, stale = false, texts }: Props) {
  const words = useWords();
  const state = value === null ? "unknown" : value ? "on" : "off";
  const text = { unknown: words.unknown, on: texts?.on ?? words.on, off: texts?.off ?? words.off }[state];
  return (
    <div className="ui-flag" data-state={state} data-stale={stale}>
      <span className="ui-flag-lamp" aria-hidden="true" />
      <span className="ui-flag-label">{label}</span>
      <span className="ui-flag-text">
        {text}
        {stale && <span className="visually-hidden">{` ${words.stale}`}</span>}
      </span>
    </div>
  );
}
