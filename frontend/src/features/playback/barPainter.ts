import { formatFlightTime } from "../../lib/moment";
import type { FlightEvent, FlightOverview } from "../../protocol/guards.gen";
import { type BarView, ticks, xOf } from "./barGeometry";
import { LANES, type Lane, laneOf } from "./flightLanes";

/** The colours of the bar by the role that they have in it. */
export interface BarColours {
  readonly ground: string;
  readonly outline: string;
  readonly gap: string;
  readonly tick: string;
  readonly text: string;
  readonly loop: string;
  readonly lane: Readonly<Record<Lane, string>>;
}

export interface BarPicture {
  readonly width: number;
  readonly height: number;
  readonly view: BarView;
  readonly edge_s: number;
  readonly overview: FlightOverview | null;
  readonly events: readonly FlightEvent[];
  /** Unix seconds of the flight's start, to place the ends of lasting events; null while not known. */
  readonly starts_s: number | null;
  readonly loop: readonly [number, number] | null;
  /** Only the ground and one lane: while the present is shown. */
  readonly isThin: boolean;
  readonly colours: BarColours;
  readonly font: string;
  readonly fontSize_px: number;
}

/** Least height of a climb in the picture: a flat flight must not look like a mountain. */
const LEAST_CLIMB_FT = 200;
const LANE_PX = 6;
const HALF_PX = 0.5;
const TICK_GAP_PX = 80;

/** Draws the flight under the handle: altitude, gaps, events and time. Sizes in CSS pixels. */
export function paintBar(context: CanvasRenderingContext2D, picture: BarPicture): void {
  const { width, height, isThin, colours } = picture;
  context.clearRect(0, 0, width, height);
  const lanes_px = isThin ? 0 : LANES.length * LANE_PX;
  const axis_px = isThin ? 0 : picture.fontSize_px + 4;
  const ground_px = Math.max(4, height - lanes_px - axis_px);
  paintGround(context, picture, ground_px);
  paintGaps(context, picture, ground_px + lanes_px);
  if (picture.loop !== null) {
    const [from_s, to_s] = picture.loop;
    const [from, to] = [xOf(from_s, picture.view, width), xOf(to_s, picture.view, width)];
    context.fillStyle = colours.loop;
    context.fillRect(from, 0, Math.max(2, to - from), 3);
  }
  paintEvents(context, picture, ground_px);
  if (!isThin) {
    paintAxis(context, picture, height);
  }
}

function paintGround(context: CanvasRenderingContext2D, picture: BarPicture, ground_px: number): void {
  const { overview, view, width, colours } = picture;
  const altitudes = overview?.altitude_ft ?? [];
  const known = altitudes.filter((altitude): altitude is number => altitude !== null);
  if (overview === null || known.length === 0) {
    return;
  }
  const low_ft = known.reduce((least, altitude) => Math.min(least, altitude));
  const high_ft = known.reduce((most, altitude) => Math.max(most, altitude));
  const span_ft = Math.max(LEAST_CLIMB_FT, high_ft - low_ft);
  const step_s = overview.duration_s / Math.max(1, altitudes.length - 1);
  context.fillStyle = colours.ground;
  context.strokeStyle = colours.outline;
  context.lineWidth = 1;
  // Each stretch without a missing altitude is one area: nothing is drawn over what is not known.
  let begin = -1;
  for (let index = 0; index <= altitudes.length; index += 1) {
    const isKnown = index < altitudes.length && altitudes[index] !== null;
    if (isKnown && begin < 0) {
      begin = index;
    } else if (!isKnown && begin >= 0) {
      const points = altitudes.slice(begin, index).map((altitude, place) => ({
        x: xOf((begin + place) * step_s, view, width),
        y: ground_px - 1 - (((altitude ?? low_ft) - low_ft) / span_ft) * (ground_px - 5),
      }));
      area(context, points, ground_px);
      begin = -1;
    }
  }
}

function area(
  context: CanvasRenderingContext2D,
  points: ReadonlyArray<{ readonly x: number; readonly y: number }>,
  bottom: number,
): void {
  const [first, last] = [points[0], points.at(-1)];
  if (first === undefined || last === undefined) {
    return;
  }
  context.beginPath();
  context.moveTo(first.x, bottom);
  for (const { x, y } of points) {
    context.lineTo(x, y);
  }
  context.lineTo(last.x, bottom);
  context.closePath();
  context.fill();
  context.beginPath();
  context.moveTo(first.x, first.y);
  for (const { x, y } of points) {
    context.lineTo(x, y);
  }
  context.stroke();
}

const HATCH_PX = 6;

function paintGaps(context: CanvasRenderingContext2D, picture: BarPicture, bottom: number): void {
  const { overview, view, width, colours } = picture;
  context.strokeStyle = colours.gap;
  context.lineWidth = 1;
  for (const [from_s = 0, to_s = 0] of overview?.gaps ?? []) {
    if (from_s >= view.to_s || to_s <= view.from_s) {
      continue;
    }
    const from = Math.max(0, xOf(from_s, view, width));
    const to = Math.min(width, Math.max(from + 2, xOf(to_s, view, width)));
    context.save();
    context.beginPath();
    context.rect(from, 0, to - from, bottom);
    context.clip();
    context.clearRect(from, 0, to - from, bottom);
    context.beginPath();
    for (let x = from - bottom; x < to; x += HATCH_PX) {
      context.moveTo(x, bottom);
      context.lineTo(x + bottom, 0);
    }
    context.stroke();
    context.restore();
  }
}

/** In the thin bar only these are shown: they are what one looks back for. */
const THIN_LANES: ReadonlySet<Lane> = new Set(["alarm", "mark"]);

function paintEvents(context: CanvasRenderingContext2D, picture: BarPicture, ground_px: number): void {
  const { events, view, width, height, isThin, colours, starts_s } = picture;
  /** How far each lane is filled: what lies within changes nothing, and a long flight has thousands of events. */
  const filled = new Map<Lane, number>();
  for (const event of events) {
    const lane = laneOf(event);
    if (lane === null || (isThin && !THIN_LANES.has(lane))) {
      continue;
    }
    const from = xOf(event.at_s, view, width);
    const until_s =
      event.until_s === null ? event.at_s : event.until_s - (starts_s ?? event.t_s - event.at_s);
    const to = Math.max(from + 2, xOf(until_s, view, width));
    if (to < 0 || from > width || !addsTo(filled, lane, to)) {
      continue;
    }
    const top = isThin ? height - LANE_PX : ground_px + LANES.indexOf(lane) * LANE_PX;
    context.fillStyle = colours.lane[lane];
    context.fillRect(from - 1, top + 1, to - from, LANE_PX - 2);
    if (lane === "mark") {
      context.fillRect(from - 1, 0, 1, top);
    }
  }
}

/** Whether an event that ends there would be seen in its lane; notes it. Oldest first. */
function addsTo(filled: Map<Lane, number>, lane: Lane, to: number): boolean {
  const isNew = to > (filled.get(lane) ?? Number.NEGATIVE_INFINITY) + HALF_PX;
  if (isNew) {
    filled.set(lane, to);
  }
  return isNew;
}

function paintAxis(context: CanvasRenderingContext2D, picture: BarPicture, height: number): void {
  const { view, width, colours, font } = picture;
  context.fillStyle = colours.text;
  context.strokeStyle = colours.tick;
  context.font = font;
  context.textBaseline = "bottom";
  context.textAlign = "left";
  const span_s = view.to_s - view.from_s;
  for (const at_s of ticks(view, width, TICK_GAP_PX)) {
    const x = xOf(at_s, view, width);
    context.beginPath();
    context.moveTo(x, 0);
    context.lineTo(x, height);
    context.stroke();
    context.fillText(formatFlightTime(at_s, span_s < 10 ? 1 : 0), x + 3, height);
  }
}
