import { type Ref, useImperativeHandle, useRef } from "react";
import { DESCRIPTION_PERIOD_MS, Pace } from "../../lib/pace";
import { InstrumentHousing } from "../dial/Dial";
import { Layer } from "../dial/Layer";
import { layerTransform, setTransform } from "../dial/layer";
import { attributeNumber, removeAttribute, setAttribute, setText } from "../dial/paint";
import "./controls.css";
import {
  areControls,
  type Controls,
  PICTURE_HALF_SIDE as halfSide,
  pedalShift,
  stickShift,
  throttleShift,
} from "./geometry";

export interface ControlCrossHandle {
  /** Show the four controls; `null`, or any missing value, shows the cross. */
  paint(controls: Controls | null, now_ms?: number): void;
}

interface Props {
  ref?: Ref<ControlCrossHandle>;
  label: string;
  noDataText: string;
  describe?: ((controls: { [axis in keyof Controls]: number }) => string) | undefined;
}

const AXES = ["aileron", "elevator", "rudder", "throttle"] as const;

const VIEW_BOX = `${-halfSide} ${-halfSide} ${2 * halfSide} ${2 * halfSide}`;
const STICK_BOX = { x: -28, y: -28, width: 24, height: 24 };
const PEDAL_BOX = { x: -22, y: 60, width: 12, height: 16 };
const THROTTLE_BOX = { x: 60, y: 34, width: 16, height: 12 };

/** Stick seen from above, pedals under it, throttle lever beside it. */
export function ControlCross({ ref, label, noDataText, describe }: Props) {
  const root = useRef<HTMLDivElement>(null);
  const description = useRef<HTMLSpanElement>(null);
  const stick = useRef<HTMLDivElement>(null);
  const pedals = useRef<HTMLDivElement>(null);
  const throttle = useRef<HTMLDivElement>(null);

  useImperativeHandle(ref, () => {
    const pace = new Pace(DESCRIPTION_PERIOD_MS);
    return {
      paint(controls, now_ms = performance.now()) {
        const picture = root.current;
        if (!areControls(controls)) {
          setAttribute(picture, "data-state", "none");
          for (const axis of AXES) {
            removeAttribute(picture, `data-${axis}`);
          }
          setText(description.current, noDataText);
          pace.reset();
          return;
        }
        const { aileron, elevator, rudder, throttle: opened } = controls;
        setTransform(stick.current, layerTransform(0, { ...stickShift(aileron, elevator), halfSide }));
        setTransform(pedals.current, layerTransform(0, { ...pedalShift(rudder), halfSide }));
        setTransform(throttle.current, layerTransform(0, { ...throttleShift(opened), halfSide }));
        for (const axis of AXES) {
          setAttribute(picture, `data-${axis}`, attributeNumber(controls[axis], 3));
        }
        setAttribute(picture, "data-state", "live");
        if (describe !== undefined && pace.due(now_ms)) {
          setText(description.current, describe(controls));
        }
      },
    };
  }, [describe, noDataText]);

  return (
    <InstrumentHousing ref={root} descriptionRef={description} label={label}>
      <svg className="inst-picture" viewBox={VIEW_BOX} aria-hidden="true">
        <g transform="translate(-16 -16)">
          <rect x="-66" y="-66" width="132" height="132" rx="3" className="inst-controls-well" />
          <path d="M-56 0H56M0 -56V56" className="inst-controls-axis" />
          <path
            d="M-56 -4V4M-28 -3V3M28 -3V3M56 -4V4M-4 -56H4M-3 -28H3M-3 28H3M-4 56H4"
            className="inst-tick"
          />
        </g>
        <g transform="translate(-16 68)">
          <rect x="-66" y="-9" width="132" height="18" rx="3" className="inst-controls-well" />
          <path d="M-56 0H56" className="inst-controls-axis" />
          <path d="M-56 -4V4M-28 -3V3M0 -4V4M28 -3V3M56 -4V4" className="inst-tick" />
        </g>
        <g transform="translate(68 40)">
          <rect x="-9" y="-122" width="18" height="132" rx="3" className="inst-controls-well" />
          <path d="M0 0V-112" className="inst-controls-axis" />
          <path d="M-4 0H4M-3 -28H3M-4 -56H4M-3 -84H3M-4 -112H4" className="inst-tick" />
        </g>
        <g className="inst-cross">
          <path d="M-66 -66L34 34M34 -66L-66 34" />
          <rect x="-66" y="-28" width="100" height="24" rx="2" />
          <text x="-16" y="-11.4">
            {noDataText}
          </text>
        </g>
      </svg>
      <Layer ref={stick} box={STICK_BOX} halfSide={halfSide} className="inst-controls-mark inst-moving">
        <g transform="translate(-16 -16)">
          <circle r="7" />
          <path d="M-11 0H-3M3 0H11M0 -11V-3M0 3V11" />
        </g>
      </Layer>
      <Layer ref={pedals} box={PEDAL_BOX} halfSide={halfSide} className="inst-controls-mark inst-moving">
        <path d="M-20 61.5H-12V74.5H-20Z" />
      </Layer>
      <Layer ref={throttle} box={THROTTLE_BOX} halfSide={halfSide} className="inst-controls-mark inst-moving">
        <path d="M61.5 36H74.5V44H61.5Z" />
      </Layer>
    </InstrumentHousing>
  );
}
