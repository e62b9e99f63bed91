import { type Ref, useImperativeHandle, useRef } from "react";
import {
  attributeNumber,
  DESCRIPTION_PERIOD_MS,
  Pace,
  removeAttribute,
  setAttribute,
  setText,
} from "../dial/paint";
import "../dial/dial.css";
import "./controls.css";
import { areControls, type Controls, pedalTransform, stickTransform, throttleTransform } from "./geometry";

export interface ControlCrossHandle {
  /** Show the four controls; `null` (and any of them missing) shows the cross. */
  paint(controls: Controls | null, now_ms?: number): void;
}

interface Props {
  ref?: Ref<ControlCrossHandle>;
  label: string;
  noDataText: string;
  describe?: ((controls: { [axis in keyof Controls]: number }) => string) | undefined;
}

const AXES = ["aileron", "elevator", "rudder", "throttle"] as const;

/** Stick seen from above, pedals under it, throttle lever beside it. */
export function ControlCross({ ref, label, noDataText, describe }: Props) {
  const root = useRef<SVGSVGElement>(null);
  const description = useRef<SVGDescElement>(null);
  const stick = useRef<SVGGElement>(null);
  const pedals = useRef<SVGPathElement>(null);
  const throttle = useRef<SVGPathElement>(null);

  useImperativeHandle(ref, () => {
    const pace = new Pace(DESCRIPTION_PERIOD_MS);
    return {
      paint(controls, now_ms = performance.now()) {
        const svg = root.current;
        if (!areControls(controls)) {
          setAttribute(svg, "data-state", "none");
          for (const axis of AXES) {
            removeAttribute(svg, `data-${axis}`);
          }
          setText(description.current, noDataText);
          pace.reset();
          return;
        }
        setAttribute(stick.current, "transform", stickTransform(controls.aileron, controls.elevator));
        setAttribute(pedals.current, "transform", pedalTransform(controls.rudder));
        setAttribute(throttle.current, "transform", throttleTransform(controls.throttle));
        for (const axis of AXES) {
          setAttribute(svg, `data-${axis}`, attributeNumber(controls[axis], 3));
        }
        setAttribute(svg, "data-state", "live");
        if (describe !== undefined && pace.due(now_ms)) {
          setText(description.current, describe(controls));
        }
      },
    };
  }, [describe, noDataText]);

  return (
    <div className="inst-frame">
      <svg
        ref={root}
        className="inst-dial inst-controls"
        viewBox="-84 -84 168 168"
        role="img"
        aria-label={label}
        data-state="none"
      >
        <desc ref={description} />
        <g transform="translate(-16 -16)">
          <rect x="-66" y="-66" width="132" height="132" rx="3" className="inst-controls-well" />
          <path d="M-56 0H56M0 -56V56" className="inst-controls-axis" />
          <path
            d="M-56 -4V4M-28 -3V3M28 -3V3M56 -4V4M-4 -56H4M-3 -28H3M-3 28H3M-4 56H4"
            className="inst-tick"
          />
          <g ref={stick} className="inst-moving inst-controls-mark">
            <circle r="7" />
            <path d="M-11 0H-3M3 0H11M0 -11V-3M0 3V11" />
          </g>
        </g>
        <g transform="translate(-16 68)">
          <rect x="-66" y="-9" width="132" height="18" rx="3" className="inst-controls-well" />
          <path d="M-56 0H56" className="inst-controls-axis" />
          <path d="M-56 -4V4M-28 -3V3M0 -4V4M28 -3V3M56 -4V4" className="inst-tick" />
          <path ref={pedals} d="M-4 -6.5H4V6.5H-4Z" className="inst-moving inst-controls-mark" />
        </g>
        <g transform="translate(68 40)">
          <rect x="-9" y="-122" width="18" height="132" rx="3" className="inst-controls-well" />
          <path d="M0 0V-112" className="inst-controls-axis" />
          <path d="M-4 0H4M-3 -28H3M-4 -56H4M-3 -84H3M-4 -112H4" className="inst-tick" />
          <path ref={throttle} d="M-6.5 -4H6.5V4H-6.5Z" className="inst-moving inst-controls-mark" />
        </g>
        <g className="inst-cross">
          <path d="M-66 -66L34 34M34 -66L-66 34" />
          <rect x="-66" y="-28" width="100" height="24" rx="2" />
          <text x="-16" y="-11.4">
            {noDataText}
          </text>
        </g>
      </svg>
    </div>
  );
}
