import {
  type BladePosition,
  bladeEnd,
  direction_deg,
  LOWER_Y,
  type Point,
  type SwitchPlace,
  UPPER_Y,
} from "./geometry";

interface WireProps {
  from: Point;
  to: Point;
  live: boolean;
  /** Draw an arrowhead at its end. */
  arrow?: boolean;
}

const HEAD_LENGTH = 8;

export function Wire({ from, to, live, arrow = false }: WireProps) {
  const length = Math.hypot(to.x - from.x, to.y - from.y);
  return (
    <g
      className="inst-path-wire"
      data-live={live}
      transform={`translate(${from.x} ${from.y}) rotate(${direction_deg(from, to)})`}
    >
      <path d={`M0 0H${arrow ? length - HEAD_LENGTH : length}`} />
      {arrow && <path className="inst-path-head" d={`M${length} 0l-${HEAD_LENGTH} -4.5v9Z`} />}
    </g>
  );
}

interface BoxProps {
  at: Point;
  width: number;
  height: number;
  live: boolean;
  /** Present, but moves nothing now: greyed and struck through. */
  ignored?: boolean;
  text: string;
}

/** A named box on the signal's path; `at` is its upper left corner. */
export function Box({ at, width, height, live, ignored = false, text }: BoxProps) {
  return (
    <g
      className="inst-path-box"
      data-live={live}
      data-ignored={ignored}
      transform={`translate(${at.x} ${at.y})`}
    >
      <rect width={width} height={height} rx="2" />
      <text x={width / 2} y={height / 2}>
        {text}
      </text>
    </g>
  );
}

interface SwitchProps {
  place: SwitchPlace;
  position: BladePosition;
  live: boolean;
}

export function SwitchSymbol({ place, position, live }: SwitchProps) {
  const { pole, contactX } = place;
  const end = bladeEnd(place, position);
  return (
    <g className="inst-path-switch" data-live={live} data-known={position !== null}>
      <circle cx={contactX} cy={UPPER_Y} r="3" />
      <circle cx={contactX} cy={LOWER_Y} r="3" />
      <path d={`M${pole.x} ${pole.y}L${end.x} ${end.y}`} className="inst-path-blade" />
      <circle cx={pole.x} cy={pole.y} r="3.6" className="inst-path-pole" />
    </g>
  );
}
