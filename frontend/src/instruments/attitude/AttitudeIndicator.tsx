import { type Ref, useImperativeHandle, useRef } from "react";
import { DESCRIPTION_PERIOD_MS, Pace } from "../../lib/pace";
import { Dial, type DialProps } from "../dial/Dial";
import { Layer, RoundWindow } from "../dial/Layer";
import { layerTransform, setTransform } from "../dial/layer";
import { attributeNumber, removeAttribute, setAttribute, setText } from "../dial/paint";
import "./attitude.css";
import {
  type Attitude,
  BALL_RADIUS,
  horizonShift,
  isAttitude,
  LADDER_BANDS,
  LADDER_RADIUS,
  ladderShift,
  ROLL_TICKS_LONG,
  ROLL_TICKS_SHORT,
  rollTurn_deg,
} from "./geometry";

export interface AttitudeHandle {
  /** Show an attitude; `null`, or any missing value, shows the cross. */
  paint(attitude: Attitude | null, now_ms?: number): void;
}

interface Props extends DialProps {
  ref?: Ref<AttitudeHandle>;
  /** One sentence for screen readers. */
  describe?: ((pitch_deg: number, roll_deg: number) => string) | undefined;
}

const HORIZON_BOX = { x: -100, y: -200, width: 200, height: 400 };
const LADDER_BOX = { x: -46, y: -214, width: 92, height: 428 };
const ROLL_POINTER_BOX = { x: -8, y: -79, width: 16, height: 13 };

/** Artificial horizon: the aircraft stands still, the world turns round it. */
export function AttitudeIndicator({ ref, label, noDataText, describe }: Props) {
  const root = useRef<HTMLDivElement>(null);
  const description = useRef<HTMLSpanElement>(null);
  const horizon = useRef<HTMLDivElement>(null);
  const ladder = useRef<HTMLDivElement>(null);
  const pointer = useRef<HTMLDivElement>(null);

  useImperativeHandle(ref, () => {
    const pace = new Pace(DESCRIPTION_PERIOD_MS);
    return {
      paint(attitude, now_ms = performance.now()) {
        const dial = root.current;
        if (!isAttitude(attitude)) {
          setAttribute(dial, "data-state", "none");
          removeAttribute(dial, "data-pitch-deg");
          removeAttribute(dial, "data-roll-deg");
          setText(description.current, noDataText);
          pace.reset();
          return;
        }
        const { pitch_deg, roll_deg } = attitude;
        const turn_deg = rollTurn_deg(roll_deg);
        setTransform(horizon.current, layerTransform(turn_deg, { y: horizonShift(pitch_deg) }));
        setTransform(ladder.current, layerTransform(turn_deg, { y: ladderShift(pitch_deg) }));
        setTransform(pointer.current, layerTransform(turn_deg));
        setAttribute(dial, "data-pitch-deg", attributeNumber(pitch_deg, 1));
        setAttribute(dial, "data-roll-deg", attributeNumber(roll_deg, 1));
        setAttribute(dial, "data-state", "live");
        if (describe !== undefined && pace.due(now_ms)) {
          setText(description.current, describe(pitch_deg, roll_deg));
        }
      },
    };
  }, [describe, noDataText]);

  const over = (
    <>
      <path d={ROLL_TICKS_LONG} className="inst-tick inst-tick-major" />
      <path d={ROLL_TICKS_SHORT} className="inst-tick inst-tick-middle" />
      <path d="M0 -79L6 -90H-6Z" className="inst-roll-index" />
      <g className="inst-moving inst-aircraft">
        <path d="M-58 -2.5H-20V7.5H-25V2.5H-58Z" />
        <path d="M58 -2.5H20V7.5H25V2.5H58Z" />
        <rect x="-3" y="-3" width="6" height="6" />
      </g>
    </>
  );
  return (
    <Dial ref={root} descriptionRef={description} label={label} noDataText={noDataText} over={over}>
      <RoundWindow radius={BALL_RADIUS}>
        <Layer ref={horizon} box={HORIZON_BOX} className="inst-horizon">
          <rect x="-100" y="-200" width="200" height="200" className="inst-sky" />
          <rect x="-100" y="0" width="200" height="200" className="inst-ground" />
          <path d="M-100 0H100" className="inst-edge" />
        </Layer>
      </RoundWindow>
      <RoundWindow radius={LADDER_RADIUS}>
        <Layer ref={ladder} box={LADDER_BOX} className="inst-ladder">
          {LADDER_BANDS.map(({ from_deg, path }) => (
            <path key={from_deg} d={path} />
          ))}
        </Layer>
      </RoundWindow>
      <Layer ref={pointer} box={ROLL_POINTER_BOX} className="inst-roll-pointer inst-moving">
        <path d="M0 -78L6.5 -67H-6.5Z" className="inst-sky-pointer" />
      </Layer>
    </Dial>
  );
}
