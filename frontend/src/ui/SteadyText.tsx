import { type Ref, useImperativeHandle, useRef } from "react";
import "./SteadyText.css";

export interface SteadyTextHandle {
  write(text: string): void;
}

interface Props {
  ref?: Ref<SteadyTextHandle>;
  /** Room for this many digits of the number font. A longer text takes more room and is not cut. */
  chars: number;
  /** The text before the first write. */
  initial?: string;
  className?: string;
}

/** Width of a digit in the number font; `ch` would measure another of its fonts. */
const EM_PER_FIGURE = 0.65;

/** A text that is written without a render, as often as its value changes, and whose changes lay out nothing else. */
export function SteadyText({ ref, chars, initial = "", className }: Props) {
  const room = useRef<HTMLSpanElement>(null);
  const text = useRef<HTMLSpanElement>(null);

  useImperativeHandle(ref, () => {
    let shown: string | null = null;
    let kept = chars;
    return {
      write(next) {
        if (next === shown || room.current === null || text.current === null) return;
        shown = next;
        if (next.length > kept) {
          kept = next.length;
          room.current.style.width = `${kept * EM_PER_FIGURE}em`;
        }
        const node = text.current.firstChild;
        if (node === null) {
          text.current.textContent = next;
        } else {
          // Keeps the text node: a new one would be styled and laid out again.
          node.nodeValue = next;
        }
      },
    };
  }, [chars]);

  return (
    <span
      ref={room}
      className={className === undefined ? "ui-steady" : `ui-steady ${className}`}
      style={{ width: `${chars * EM_PER_FIGURE}em` }}
    >
      <span ref={text} className="ui-steady-text">
        {initial}
      </span>
    </span>
  );
}
