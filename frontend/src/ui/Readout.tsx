import { type CSSProperties, type ReactNode, type Ref, useImperativeHandle, useRef } from "react";
import { usePress } from "./refusal";
import { SteadyText, type SteadyTextHandle } from "./SteadyText";
import { Tooltip } from "./Tooltip";
import type { DataState } from "./words";
import "./Readout.css";
import { useWords } from "./words";

export interface ReadoutHandle {
  /** Show a number as text; `null` is no data, whatever the state. */
  paint(text: string | null, state: DataState): void;
}

/** A list of readings in columns. */
export function ReadoutGrid({
  columns = 1,
  className,
  children,
}: {
  columns?: number | undefined;
  className?: string | undefined;
  children: ReactNode;
}) {
  return (
    <dl
      className={className === undefined ? "ui-readouts" : `ui-readouts ${className}`}
      data-columns={columns}
      style={{ "--columns": columns } as CSSProperties}
    >
      {children}
    </dl>
  );
}

/** What a press on a reading does. */
export interface ReadoutPress {
  /** Accessible name. */
  readonly label: string;
  readonly onPress: () => void;
  /** Why it does nothing: the answer to a press. */
  readonly disabledReason?: string | undefined;
}

interface Props {
  ref?: Ref<ReadoutHandle>;
  label: string;
  /** What the label means, where it is a word of the simulator's or of the wire. */
  hint?: string | undefined;
  unit?: string | undefined;
  /** Room for the number, in characters. A longer number takes more room and is not cut. */
  chars?: number | undefined;
  size?: "normal" | "large" | undefined;
  press?: ReadoutPress | undefined;
}

/** Shown without a number: as wide as one, and cannot be taken for a zero. */
const DASHES = "\u2013\u2009\u2013\u2009\u2013";

/** One reading: name, number, unit, and whether it is live. Painted through its handle, without a render. */
export function Readout({ ref, label, hint, unit, chars = 7, size = "normal", press }: Props) {
  const words = useWords();
  const root = useRef<HTMLDivElement>(null);
  const number = useRef<SteadyTextHandle>(null);
  const word = useRef<HTMLSpanElement>(null);
  const told = useRef<DataState>("none");

  useImperativeHandle(ref, () => {
    function tell(state: DataState): void {
      if (root.current === null || word.current === null) return;
      told.current = state;
      root.current.dataset["state"] = state;
      word.current.textContent = { live: "", stale: words.stale, none: words.noData }[state];
    }

    // Written again in a new language: the words change, the state does not.
    tell(told.current);
    return {
      paint(text, state) {
        const shown = text === null ? "none" : state;
        number.current?.write(shown === "none" || text === null ? DASHES : text);
        if (shown !== told.current) {
          tell(shown);
        }
      },
    };
  }, [words]);

  return (
    <div ref={root} className="ui-readout" data-size={size}>
      <dt className="ui-readout-label" title={hint}>
        {label}
      </dt>
      <dd className="ui-readout-value">
        <SteadyText ref={number} chars={chars} initial={DASHES} className="ui-readout-number" />
        {unit !== undefined && <span className="ui-readout-unit">{unit}</span>}
        <span ref={word} className="visually-hidden" />
        {press !== undefined && <PressArea {...press} />}
      </dd>
    </div>
  );
}

/** A button over the whole reading. */
function PressArea({ label, onPress, disabledReason }: ReadoutPress) {
  const press = usePress(disabledReason);
  return (
    <Tooltip text={disabledReason ?? label}>
      <button
        type="button"
        className="ui-readout-press"
        aria-label={label}
        aria-description={disabledReason}
        aria-disabled={disabledReason !== undefined || undefined}
        onClick={() => press(onPress)}
      />
    </Tooltip>
  );
}
