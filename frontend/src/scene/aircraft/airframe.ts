/** A point of the airframe in metres: ahead, right, up. */
export type Point = readonly [ahead: number, right: number, up: number];
type Colour = readonly [red: number, green: number, blue: number];

/** A flat face of three or four corners, seen from both sides. */
export interface Face {
  readonly corners: readonly Point[];
  /** Roughly the outward direction of the part that it belongs to. */
  readonly outwards: Point;
  readonly colour: Colour;
}

const BODY: Colour = [1, 1, 1];
const GLASS: Colour = [0.16, 0.2, 0.24];
const NOSE: Colour = [0.3, 0.3, 0.32];
/** The lights of aircraft: red on the left, green on the right. */
const LEFT_TIP: Colour = [1, 0.22, 0.18];
const RIGHT_TIP: Colour = [0.15, 0.95, 0.35];
/** Stations of the fuselage: position along it, half width, half height, height of the middle. */
const STATIONS = [
  [1.02, 0.03, 0.03, 0.0],
  [0.9, 0.1, 0.1, 0.0],
  [0.55, 0.15, 0.16, 0.02],
  [0.05, 0.16, 0.18, 0.04],
  [-0.4, 0.1, 0.12, 0.05],
  [-1.05, 0.035, 0.05, 0.07],
] as const;
const SIDES = 8;
/**
 * Light from the upper left, fixed to the airframe, so that its shape shows from all sides without lights in the
 * scene.
 */
const LIGHT: Point = [0.3, -0.35, 0.89];
const DARKEST = 0.42;

/** A small aircraft with a high wing, 2.1 m long and 3 m wide. */
export function airframeFaces(): readonly Face[] {
  const wing = (side: 1 | -1): readonly Face[] => [
    ...plate(
      [
        [0.32, 0, 0.2],
        [-0.12, 0, 0.2],
        [-0.09, side * 1.25, 0.26],
        [0.25, side * 1.25, 0.26],
      ],
      [0, 0, 0.022],
      BODY,
    ),
    ...plate(
      [
        [0.25, side * 1.25, 0.26],
        [-0.09, side * 1.25, 0.26],
        [-0.07, side * 1.5, 0.28],
        [0.16, side * 1.5, 0.28],
      ],
      [0, 0, 0.018],
      side === 1 ? RIGHT_TIP : LEFT_TIP,
    ),
    ...plate(
      [
        [-0.76, 0, 0.09],
        [-1.04, 0, 0.09],
        [-1.04, side * 0.52, 0.09],
        [-0.88, side * 0.52, 0.09],
      ],
      [0, 0, 0.014],
      BODY,
    ),
  ];
  return [
    ...fuselage(),
    ...wing(1),
    ...wing(-1),
    ...plate(
      [
        [-0.74, 0, 0.08],
        [-1.04, 0, 0.08],
        [-1.1, 0, 0.5],
        [-0.94, 0, 0.5],
      ],
      [0, 0.014, 0],
      BODY,
    ),
  ];
}

function fuselage(): readonly Face[] {
  const ring = ([ahead, width, height, middle]: (typeof STATIONS)[number]): Point[] =>
    Array.from({ length: SIDES }, (_, side) => {
      const angle = ((side + 0.5) * 2 * Math.PI) / SIDES;
      return [ahead, width * Math.sin(angle), middle + height * Math.cos(angle)];
    });
  const rings = STATIONS.map(ring);
  return rings.slice(1).flatMap((after, index) => {
    const before = rings[index] ?? after;
    return before.map((corner, side): Face => {
      const next = (side + 1) % SIDES;
      const isAbove = Math.min(side, SIDES - 1 - side) < 2;
      return {
        corners: [corner, after[side] ?? corner, after[next] ?? corner, before[next] ?? corner],
        outwards: [0, corner[1] + (before[next] ?? corner)[1], Math.cos(((side + 1) * 2 * Math.PI) / SIDES)],
        colour: index === 0 ? NOSE : index === 2 && isAbove ? GLASS : BODY,
      };
    });
  });
}

/** A plate with two faces and an edge, this thick to both sides. */
function plate(outline: readonly Point[], thick: Point, colour: Colour): readonly Face[] {
  const side = (sign: 1 | -1): Point[] => outline.map((corner) => plus(corner, scaled(thick, sign)));
  const [top, bottom] = [side(1), side(-1)];
  const middle = scaled(outline.reduce(plus), 1 / outline.length);
  const edges = outline.map((corner, index): Face => {
    const next = (index + 1) % outline.length;
    return {
      corners: [top[index] ?? corner, top[next] ?? corner, bottom[next] ?? corner, bottom[index] ?? corner],
      outwards: plus(scaled(plus(corner, outline[next] ?? corner), 0.5), scaled(middle, -1)),
      colour,
    };
  });
  return [
    { corners: top, outwards: thick, colour },
    { corners: bottom, outwards: scaled(thick, -1), colour },
    ...edges,
  ];
}

/** Brightness of a face, 0..1. */
export function shadeOf({ corners, outwards }: Face): number {
  const [first = [0, 0, 0], second = first, third = first] = corners;
  const one = plus(second, scaled(first, -1));
  const other = plus(third, scaled(first, -1));
  const normal: Point = [
    one[1] * other[2] - one[2] * other[1],
    one[2] * other[0] - one[0] * other[2],
    one[0] * other[1] - one[1] * other[0],
  ];
  const length = Math.hypot(...normal) * (dot(normal, outwards) < 0 ? -1 : 1);
  return DARKEST + (1 - DARKEST) * Math.max(0, dot(normal, LIGHT) / (length || 1));
}

function plus(one: Point, other: Point): Point {
  return [one[0] + other[0], one[1] + other[1], one[2] + other[2]];
}

function scaled([ahead, right, up]: Point, by: number): Point {
  return [ahead * by, right * by, up * by];
}

function dot(one: Point, other: Point): number {
  return one[0] * other[0] + one[1] * other[1] + one[2] * other[2];
}
