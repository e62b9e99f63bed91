import type { Aircraft } from "../../lib/aircraft";
import type { Position } from "../../lib/geodesy";
import { EDGE, HOME, MEASURE, PLAN, STRONG, UNSENT } from "../colours";
import { legPoints } from "../legs/geometry";
import { type Dot, type DrawnPlan, dotsOf, type LineKind, linesOf } from "../legs/shape";
import { drawDot, drawLine, type Pen } from "./ink";
import { type FlatView, type ScreenPoint, toScreen } from "./projection";
import type { Words } from "./Words";

export interface FlatAircraft {
  readonly plan: Aircraft;
  readonly place: Position;
  /** Null: not known; a ring is drawn in place of an arrow. */
  readonly heading_deg: number | null;
  readonly colour: string;
  readonly label: string;
  readonly isLive: boolean;
}

export interface MarkedPlace extends Position {
  readonly label: string;
}

const FADED = "8c";

/** The pen of each line that is seen from above: a stem is not. */
function pensOf(aircraft: Aircraft): Readonly<Partial<Record<LineKind, Pen>>> {
  const colour = PLAN[aircraft];
  // The simulator's plan is dashed: told apart without colours too.
  const isDashed = aircraft === "hil";
  return {
    leg: { colour, width_px: 2, isDashed },
    unsentLeg: { colour: UNSENT, width_px: 2, isDashed },
    activeLeg: { colour: STRONG, width_px: 3.5, isDashed },
    oldLeg: { colour: `${colour}${FADED}`, width_px: 1.5, isDashed },
    turn: { colour, width_px: 1.5 },
    ring: { colour, width_px: 1 },
    activeRing: { colour: STRONG, width_px: 1.5 },
  };
}

/** A plan as on the globe: legs, capture circles, and each waypoint with what stands beside it. */
export function drawPlan(
  context: CanvasRenderingContext2D,
  view: FlatView,
  aircraft: Aircraft,
  plan: DrawnPlan,
  words: Words,
): void {
  const pens = pensOf(aircraft);
  for (const { kind, places } of linesOf(plan)) {
    const pen = pens[kind];
    if (pen !== undefined) {
      const seen = places.map((place) => toScreen(view, place));
      drawLine(context, seen, pen);
    }
  }
  for (const dot of dotsOf(plan)) {
    drawWaypoint(context, toScreen(view, dot.at), PLAN[aircraft], dot, words);
  }
}

/** Hollow: not on the board. */
function drawWaypoint(
  context: CanvasRenderingContext2D,
  at: ScreenPoint,
  plain: string,
  { label, isActive, isSelected, isUnsent }: Dot,
  words: Words,
): void {
  const isStrong = isActive || isSelected;
  const colour = isUnsent ? UNSENT : plain;
  const fill = isActive ? STRONG : isUnsent ? EDGE : colour;
  const rim = isSelected ? STRONG : isActive || isUnsent ? colour : EDGE;
  drawDot(context, at, isStrong ? 6 : 4.5, fill, { colour: rim, width_px: isStrong || isUnsent ? 2.5 : 1 });
  words.write(label, at, 8, isStrong && !isUnsent ? STRONG : colour);
}

export function drawHome(
  context: CanvasRenderingContext2D,
  view: FlatView,
  home: MarkedPlace,
  words: Words,
): void {
  const at = toScreen(view, home);
  drawDot(context, at, 5, EDGE, { colour: HOME, width_px: 3 });
  words.write(home.label, at, 8, HOME);
}

/** An arrow in its heading; hollow while it is not live. */
export function drawAircraft(
  context: CanvasRenderingContext2D,
  view: FlatView,
  { place, heading_deg, colour, label, isLive }: FlatAircraft,
  words: Words,
): void {
  const at = toScreen(view, place);
  const fill = isLive ? colour : "transparent";
  if (heading_deg === null) {
    drawDot(context, at, 8, fill, { colour, width_px: 2 });
  } else {
    drawArrow(context, at, heading_deg, fill, colour);
  }
  words.write(label, at, 14, colour);
}

/** Nose, right wing, tail, left wing; pixels, the nose up. */
const ARROW = [
  [0, -15],
  [10, 12],
  [0, 6],
  [-10, 12],
] as const;

function drawArrow(
  context: CanvasRenderingContext2D,
  { x, y }: ScreenPoint,
  heading_deg: number,
  fill: string,
  colour: string,
): void {
  context.save();
  context.translate(x, y);
  context.rotate((heading_deg * Math.PI) / 180);
  context.beginPath();
  for (const [right, down] of ARROW) {
    context.lineTo(right, down);
  }
  context.closePath();
  context.lineJoin = "round";
  context.lineWidth = 5;
  context.strokeStyle = EDGE;
  context.stroke();
  context.lineWidth = 2;
  context.strokeStyle = colour;
  context.stroke();
  context.fillStyle = fill;
  context.fill();
  context.restore();
}

/** The line of the distance tool, with its length at each corner; or the outline of an area. */
export function drawDistance(
  context: CanvasRenderingContext2D,
  view: FlatView,
  places: readonly MarkedPlace[],
  words: Words,
  colour = MEASURE,
): void {
  for (const [index, to] of places.entries()) {
    const from = places[index - 1];
    if (from !== undefined) {
      const way = legPoints({ ...from, altitude_ft: 0 }, { ...to, altitude_ft: 0 });
      drawLine(
        context,
        way.map((place) => toScreen(view, place)),
        { colour, width_px: 2.5 },
      );
    }
  }
  for (const place of places) {
    const at = toScreen(view, place);
    drawDot(context, at, 3.5, colour, { colour, width_px: 1 });
    words.write(place.label, at, 8, colour);
  }
}
