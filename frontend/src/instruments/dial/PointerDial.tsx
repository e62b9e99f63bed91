import { type Ref, useImperativeHandle, useRef } from "react";
import { DESCRIPTION_PERIOD_MS, NUMBER_PERIOD_MS, Pace } from "../../lib/pace";
import { Dial, type DialProps } from "./Dial";
import { Layer } from "./Layer";
import { layerTransform, setTransform } from "./layer";
import { attributeNumber, removeAttribute, setAttribute, setText } from "./paint";
import { isDrawable, type Reach, round } from "./scale";

export interface DialHandle {
  /** Show a value in the dial's own unit; `null` or NaN shows the cross. */
  paint(value: number | null, now_ms?: number): void;
}

/** The geometry of a one-pointer instrument: numbers and paths. */
export interface PointerGeometry {
  readonly ticksMinor: string;
  readonly ticksMiddle: string;
  readonly ticksMajor: string;
  readonly numerals: readonly { readonly text: string; readonly x: number; readonly y: number }[];
  /** Height of the number's window and of the caption, and width of the window. */
  readonly window: { readonly y: number; readonly width: number };
  readonly captionY: number;
  /** Filled symbols on the face, if the scale has any. */
  readonly signs?: string;
  readonly pointerAngle_deg: (value: number) => number;
  readonly reach: (value: number) => Reach;
}

/** Props of the three pointer instruments. */
export interface PointerDialProps extends DialProps {
  ref?: Ref<DialHandle>;
  /** Engraved on the face. */
  caption: string;
  unit: string;
  /** Text of the plate that is shown while the value is off the scale. */
  offScaleText: string;
  /** Formats the number in the window. */
  format: (value: number) => string;
  /** One sentence for screen readers. */
  describe?: ((value: number) => string) | undefined;
}

interface Props extends PointerDialProps {
  geometry: PointerGeometry;
  /** Name of the `data-` attribute that carries the exact value, with its unit: `data-airspeed-kt`. */
  attribute: `data-${string}`;
  decimals: number;
}

const WINDOW_HEIGHT = 20;
const POINTER_BOX = { x: -5, y: -85, width: 10, height: 107 };

/** A round instrument with one pointer, and the number in a window. */
export function PointerDial(props: Props) {
  const {
    ref,
    label,
    noDataText,
    caption,
    unit,
    offScaleText,
    format,
    describe,
    geometry,
    attribute,
    decimals,
  } = props;
  const root = useRef<HTMLDivElement>(null);
  const description = useRef<HTMLSpanElement>(null);
  const pointer = useRef<HTMLDivElement>(null);
  const number = useRef<SVGTextElement>(null);

  useImperativeHandle(ref, () => {
    const numberPace = new Pace(NUMBER_PERIOD_MS);
    const descriptionPace = new Pace(DESCRIPTION_PERIOD_MS);
    return {
      paint(value, now_ms = performance.now()) {
        const dial = root.current;
        if (!isDrawable(value)) {
          setAttribute(dial, "data-state", "none");
          removeAttribute(dial, attribute);
          removeAttribute(dial, "data-reach");
          setText(description.current, noDataText);
          numberPace.reset();
          descriptionPace.reset();
          return;
        }
        setTransform(pointer.current, layerTransform(round(geometry.pointerAngle_deg(value))));
        setAttribute(dial, attribute, attributeNumber(value, decimals));
        setAttribute(dial, "data-reach", geometry.reach(value));
        setAttribute(dial, "data-state", "live");
        if (numberPace.due(now_ms)) {
          setText(number.current, format(value));
        }
        if (describe !== undefined && descriptionPace.due(now_ms)) {
          setText(description.current, describe(value));
        }
      },
    };
  }, [attribute, decimals, describe, format, geometry, noDataText]);

  const { window } = geometry;
  const face = (
    <>
      <path d={geometry.ticksMinor} className="inst-tick" />
      <path d={geometry.ticksMiddle} className="inst-tick inst-tick-middle" />
      <path d={geometry.ticksMajor} className="inst-tick inst-tick-major" />
      {geometry.signs !== undefined && <path d={geometry.signs} className="inst-sign" />}
    </>
  );
  const over = (
    <>
      {/* Over the pointer, which would cover what it points at. */}
      {geometry.numerals.map(({ text, x, y }) => (
        <text key={`${x} ${y}`} x={x} y={y} className="inst-numeral inst-over-pointer">
          {text}
        </text>
      ))}
      <text y={geometry.captionY} className="inst-caption inst-over-pointer">
        {caption}
      </text>
      <circle r="7" className="inst-hub inst-moving" />
      <g transform={`translate(0 ${window.y})`}>
        <rect
          x={-window.width / 2}
          y={-WINDOW_HEIGHT / 2}
          width={window.width}
          height={WINDOW_HEIGHT}
          rx="2"
          className="inst-window"
        />
        <text ref={number} y="0.6" className="inst-window-number inst-moving" />
        <text y="18" className="inst-caption">
          {unit}
        </text>
      </g>
      <g className="inst-off-scale" transform={`translate(0 ${geometry.captionY - 2.6})`}>
        <rect x="-41" y="-7" width="82" height="14" rx="2" />
        <text y="2.8">{offScaleText}</text>
      </g>
    </>
  );
  return (
    <Dial
      ref={root}
      descriptionRef={description}
      label={label}
      noDataText={noDataText}
      face={face}
      over={over}
    >
      <Layer ref={pointer} box={POINTER_BOX} className="inst-moving">
        <path d="M0 -83L3.4 -70L3.4 14Q3.4 20 0 20Q-3.4 20 -3.4 14L-3.4 -70Z" className="inst-pointer" />
      </Layer>
    </Dial>
  );
}
