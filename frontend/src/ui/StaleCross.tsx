import "./StaleCross.css";

interface Props {
  text: string;
  /** Hidden while the data beneath is live. */
  shown?: boolean | undefined;
}

/** A red cross with text over a box without live data. The box must be `position: relative`. */
export function StaleCross({ text, shown = true }: Props) {
  if (!shown) {
    return null;
  }
  return (
    <div className="ui-cross">
      <svg viewBox="0 0 100 100" preserveAspectRatio="none" aria-hidden="true">
        <path d="M2 2L98 98M98 2L2 98" vectorEffect="non-scaling-stroke" />
      </svg>
      <span className="ui-cross-text">{text}</span>
    </div>
  );
}
