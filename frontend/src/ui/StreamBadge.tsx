import { type Ref, useImperativeHandle, useRef } from "react";
import type { DataState } from "./words";
import "./StreamBadge.css";
import { dataWord, useWords } from "./words";

export interface StreamBadgeHandle {
  /** Show the stream's state and its age as text ("0,3 s"); an empty age shows only the state. */
  paint(state: DataState, ageText: string): void;
}

interface Props {
  ref?: Ref<StreamBadgeHandle>;
  /** What the age is of: read out before it. */
  label?: string | undefined;
}

/** A small mark in a panel's head: whether this group is live, and the age of its newest value. */
export function StreamBadge({ ref, label }: Props) {
  const words = useWords();
  const root = useRef<HTMLSpanElement>(null);
  const word = useRef<HTMLSpanElement>(null);
  const age = useRef<HTMLSpanElement>(null);
  const told = useRef<DataState>("none");

  useImperativeHandle(ref, () => {
    function tell(state: DataState): void {
      if (root.current === null || word.current === null) return;
      told.current = state;
      root.current.dataset["state"] = state;
      word.current.textContent = dataWord(words, state);
    }

    // Written again in a new language: the word changes, the state does not.
    tell(told.current);
    return {
      paint(state, ageText) {
        if (state !== told.current) {
          tell(state);
        }
        if (age.current !== null && age.current.textContent !== ageText) {
          age.current.textContent = ageText;
        }
      },
    };
  }, [words]);

  return (
    <span ref={root} className="ui-badge">
      {label !== undefined && <span className="visually-hidden">{label}</span>}
      <span className="ui-badge-lamp" aria-hidden="true" />
      <span ref={word} className="ui-badge-word" />
      <span ref={age} className="ui-badge-age" />
    </span>
  );
}
