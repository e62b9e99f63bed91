import { type Ref, useId, useImperativeHandle, useRef } from "react";
import { Dial, type DialProps } from "../dial/Dial";
import {
  attributeNumber,
  DESCRIPTION_PERIOD_MS,
  Pace,
  removeAttribute,
  setAttribute,
  setText,
} from "../dial/paint";
import "./attitude.css";
import {
  type Attitude,
  BALL_RADIUS,
  horizonTransform,
  isAttitude,
  LADDER_BANDS,
  LADDER_RADIUS,
  ladderTransform,
  ROLL_TICKS_LONG,
  ROLL_TICKS_SHORT,
  rollTransform,
} from "./geometry";

export interface AttitudeHandle {
  /** Show an attitude, or with `null` (and with any value missing) the cross. */
  paint(attitude: Attitude | null, now_ms?: number): void;
}

interface Props extends DialProps {
  ref?: Ref<AttitudeHandle>;
  /** One sentence for screen readers. */
  describe?: ((pitch_deg: number, roll_deg: number) => string) | undefined;
}

/** Artificial horizon: the aircraft stands still, the world turns round it. */
export function AttitudeIndicator({ ref, label, noDataText, describe }: Props) {
  const root = useRef<SVGSVGElement>(null);
  const description = useRef<SVGDescElement>(null);
  const horizon = useRef<SVGGElement>(null);
  const ladder = useRef<SVGGElement>(null);
  const pointer = useRef<SVGPathElement>(null);
  const ballClip = useId();
  const ladderClip = useId();

  useImperativeHandle(ref, () => {
    const pace = new Pace(DESCRIPTION_PERIOD_MS);
    return {
      paint(attitude, now_ms = performance.now()) {
        const svg = root.current;
        if (!isAttitude(attitude)) {
          setAttribute(svg, "data-state", "none");
          removeAttribute(svg, "data-pitch-deg");
          removeAttribute(svg, "data-roll-deg");
          setText(description.current, noDataText);
          pace.reset();
          return;
        }
        const { pitch_deg, roll_deg } = attitude;
        setAttribute(horizon.current, "transform", horizonTransform(pitch_deg, roll_deg));
        setAttribute(ladder.current, "transform", ladderTransform(pitch_deg, roll_deg));
        setAttribute(pointer.current, "transform", rollTransform(roll_deg));
        setAttribute(svg, "data-pitch-deg", attributeNumber(pitch_deg, 1));
        setAttribute(svg, "data-roll-deg", attributeNumber(roll_deg, 1));
        setAttribute(svg, "data-state", "live");
        if (describe !== undefined && pace.due(now_ms)) {
          setText(description.current, describe(pitch_deg, roll_deg));
        }
      },
    };
  }, [describe, noDataText]);

  return (
    <Dial
      ref={root}
      descriptionRef={description}
      label={label}
      noDataText={noDataText}
      className="inst-attitude"
    >
      <defs>
        <clipPath id={ballClip}>
          <circle r={BALL_RADIUS} />
        </clipPath>
        <clipPath id={ladderClip}>
          <circle r={LADDER_RADIUS} />
        </clipPath>
      </defs>
      <g className="inst-moving">
        <g clipPath={`url(#${ballClip})`}>
          <g ref={horizon}>
            <rect x="-100" y="-200" width="200" height="200" className="inst-sky" />
            <rect x="-100" y="0" width="200" height="200" className="inst-ground" />
            <path d="M-100 0H100" className="inst-horizon" />
          </g>
        </g>
        <g clipPath={`url(#${ladderClip})`}>
          <g ref={ladder} className="inst-ladder">
            {LADDER_BANDS.map(({ from_deg, path }) => (
              <path key={from_deg} d={path} />
            ))}
          </g>
        </g>
        <path ref={pointer} d="M0 -78L6.5 -67H-6.5Z" className="inst-sky-pointer" />
      </g>
      <path d={ROLL_TICKS_LONG} className="inst-tick inst-tick-major" />
      <path d={ROLL_TICKS_SHORT} className="inst-tick inst-tick-middle" />
      <path d="M0 -79L6 -90H-6Z" className="inst-roll-index" />
      <g className="inst-moving inst-aircraft">
        <path d="M-58 -2.5H-20V7.5H-25V2.5H-58Z" />
        <path d="M58 -2.5H20V7.5H25V2.5H58Z" />
        <rect x="-3" y="-3" width="6" height="6" />
      </g>
    </Dial>
  );
}
