import { type Ref, useImperativeHandle, useRef } from "react";
import { NUMBER_PERIOD_MS, Pace } from "../../lib/pace";
import { attributeNumber, removeAttribute, setAttribute, setText } from "../dial/paint";
import { isDrawable } from "../dial/scale";
import { fillTransform, markerTransform, type Orientation, type ServoKind, servoBar } from "./geometry";
import "./servo.css";

export interface ServoBarHandle {
  /** Show a position; `null` or NaN empties the bar and says so. */
  paint(value: number | null, now_ms?: number): void;
}

interface Props {
  ref?: Ref<ServoBarHandle>;
  label: string;
  /** For screen readers, instead of the number without live data; sighted users see dashes and a crossed-out bar. */
  noDataText: string;
  /** The number under the bar, in the reader's own notation. */
  format: (value: number) => string;
  kind?: ServoKind | undefined;
  orientation?: Orientation | undefined;
}

const DASHES = "\u2013\u2009\u2013\u2009\u2013";

/** One servo's position as a bar and a number. Read only. */
export function ServoBar({
  ref,
  label,
  noDataText,
  format,
  kind = "surface",
  orientation = "vertical",
}: Props) {
  const root = useRef<HTMLDivElement>(null);
  const fill = useRef<HTMLSpanElement>(null);
  const marker = useRef<HTMLSpanElement>(null);
  const number = useRef<HTMLSpanElement>(null);

  useImperativeHandle(ref, () => {
    const pace = new Pace(NUMBER_PERIOD_MS);
    return {
      paint(value, now_ms = performance.now()) {
        if (!isDrawable(value)) {
          setAttribute(root.current, "data-state", "none");
          removeAttribute(root.current, "data-value");
          removeAttribute(root.current, "data-limited");
          setText(number.current, "");
          pace.reset();
          return;
        }
        const { place, limited } = servoBar(kind, value);
        if (fill.current !== null && marker.current !== null) {
          fill.current.style.transform = fillTransform(kind, orientation, place);
          marker.current.style.transform = markerTransform(orientation, place);
        }
        setAttribute(root.current, "data-value", attributeNumber(value, 3));
        setAttribute(root.current, "data-limited", String(limited));
        setAttribute(root.current, "data-state", "live");
        if (pace.due(now_ms)) {
          setText(number.current, format(value));
        }
      },
    };
  }, [format, kind, orientation]);

  return (
    // biome-ignore lint/a11y/useSemanticElements: a fieldset is for things to fill in, and here there are none
    <div
      ref={root}
      className="inst-servo"
      role="group"
      aria-label={label}
      data-state="none"
      data-kind={kind}
      data-orientation={orientation}
    >
      <span className="inst-servo-label" aria-hidden="true">
        {label}
      </span>
      <span className="inst-servo-track" aria-hidden="true">
        <span ref={fill} className="inst-servo-fill" />
        <span ref={marker} className="inst-servo-marker" />
      </span>
      <span className="inst-servo-value">
        <span ref={number} className="inst-servo-number" />
        <span className="inst-servo-none">
          <span aria-hidden="true">{DASHES}</span>
          <span className="visually-hidden">{noDataText}</span>
        </span>
      </span>
    </div>
  );
}
