import { type Ref, useId, useImperativeHandle, useMemo, useRef } from "react";
import { DESCRIPTION_PERIOD_MS, NUMBER_PERIOD_MS, Pace } from "../../lib/pace";
import type { UnitName } from "../../lib/units";
import { setTransform } from "../dial/layer";
import { attributeNumber, removeAttribute, setAttribute, setText } from "../dial/paint";
import {
  bugPercent,
  marksBeside,
  middleOf,
  numbersOf,
  onTape,
  shiftPercent,
  type TapeScale,
} from "./geometry";
import "./tape.css";

export interface TapeHandle {
  /** Show a value and its target, both in the usual unit; a value of `null` or NaN shows the cross. */
  paint(value: number | null, target: number | null, now_ms?: number): void;
}

export interface TapeProps {
  ref?: Ref<TapeHandle>;
  scale: TapeScale;
  /** The unit in which it is painted, whatever is on its face. */
  usual: UnitName;
  /** Name of the `data-` attribute that carries the exact value, with its unit: `data-altitude-ft`. */
  attribute: `data-${string}`;
  /** Accessible name. */
  label: string;
  /** The unit's symbol, under the tape. */
  unit: string;
  /** On which side of the horizon it stands: the index points to it. */
  side: "left" | "right";
  noDataText: string;
  format: (value: number) => string;
  /** One sentence for screen readers. */
  describe: (value: number) => string;
}

/** A scale that slides behind its index, with the number in a window and the target as a bug. */
export function Tape(props: TapeProps) {
  const { ref, scale, usual, attribute, label, unit, side, noDataText, format, describe } = props;
  const description = useId();
  const root = useRef<HTMLDivElement>(null);
  const told = useRef<HTMLSpanElement>(null);
  const strip = useRef<HTMLDivElement>(null);
  const bug = useRef<HTMLDivElement>(null);
  const number = useRef<HTMLSpanElement>(null);
  const rows = useMemo(() => numbersOf(scale, 0).length, [scale]);

  useImperativeHandle(ref, () => {
    const numberPace = new Pace(NUMBER_PERIOD_MS);
    const descriptionPace = new Pace(DESCRIPTION_PERIOD_MS);
    let middle = Number.NaN;
    /** The strip is numbered anew only when its middle changes. */
    function slide(shown: number): void {
      const nearest = middleOf(scale, shown);
      if (nearest !== middle) {
        middle = nearest;
        const texts = numbersOf(scale, middle);
        strip.current?.querySelectorAll(".tape-number").forEach((row, at) => {
          setText(row, texts[at] ?? "");
        });
      }
      setTransform(strip.current, `translateY(${shiftPercent(scale, shown, middle)}cqh)`);
    }
    function aim(shown: number, target: number | null): void {
      const at = onTape(scale, target, usual);
      setAttribute(root.current, "data-target", at === null ? "none" : "shown");
      if (at !== null) {
        setTransform(bug.current, `translateY(${bugPercent(scale, shown, at)}cqh)`);
      }
    }
    return {
      paint(value, target, now_ms = performance.now()) {
        const shown = onTape(scale, value, usual);
        if (shown === null || value === null) {
          setAttribute(root.current, "data-state", "none");
          removeAttribute(root.current, attribute);
          setText(told.current, noDataText);
          numberPace.reset();
          descriptionPace.reset();
          return;
        }
        slide(shown);
        aim(shown, target);
        setAttribute(root.current, attribute, attributeNumber(value, 1));
        setAttribute(root.current, "data-state", "live");
        if (numberPace.due(now_ms)) {
          setText(number.current, format(value));
        }
        if (descriptionPace.due(now_ms)) {
          setText(told.current, describe(value));
        }
      },
    };
  }, [scale, usual, attribute, noDataText, format, describe]);

  const step = (scale.major / scale.seen) * 100;
  return (
    <div className="tape" data-side={side}>
      <div
        ref={root}
        className="tape-face"
        role="img"
        aria-label={label}
        aria-describedby={description}
        data-state="none"
        data-target="none"
      >
        <span ref={told} id={description} hidden />
        <div ref={strip} className="tape-strip tape-moving" aria-hidden="true">
          {Array.from({ length: rows }, (_, row) => (
            <div
              // biome-ignore lint/suspicious/noArrayIndexKey: the rows stand still, their numbers change
              key={row}
              className="tape-row"
              style={{
                top: `${50 + (row - marksBeside(scale)) * step}cqh`,
                height: `${step}cqh`,
                backgroundSize: `100% ${(scale.minor / scale.major) * 100}%`,
              }}
            >
              <span className="tape-number" />
            </div>
          ))}
        </div>
        <div ref={bug} className="tape-bug tape-moving" aria-hidden="true" />
        <div className="tape-window tape-moving" aria-hidden="true">
          <span ref={number} />
        </div>
        <div className="tape-cross" aria-hidden="true" />
      </div>
      <span className="tape-unit" aria-hidden="true">
        {unit}
      </span>
    </div>
  );
}
