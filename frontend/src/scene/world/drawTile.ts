import type { Position } from "../../lib/geodesy";
import type { GroundLook } from "../look";
import { type Cell, SHAPE_UNITS, type Shapes, southOf, westOf } from "./cell";
import { drawRunway } from "./runways";
import { northing, type Projection, type TileFrame, WORLD_TILE_PX } from "./tiling";

type Context = OffscreenCanvasRenderingContext2D;

/** A cell's shapes as paths, in parts of its side from its south-west corner, north up. */
interface CellPaths {
  readonly land: Path2D;
  readonly coast: readonly Stretch[];
  readonly borders: readonly Stretch[];
}

/** A short part of a line with its bounds: strokes cost by their length, and most of a cell lies beside a tile. */
interface Stretch {
  readonly path: Path2D;
  readonly west: number;
  readonly east: number;
  readonly south: number;
  readonly north: number;
}

/** Points of a stretch. */
const STRETCH = 96;

/** Width of the shallows, metres, while they would be wider than a line and narrower than a tile. */
const SHALLOWS_M = 900;
const SHALLOWS_PX = [3, 180] as const;
const COAST_PX = 1.4;
const BORDER_PX = 1.6;
/** Runways are drawn while a pixel is smaller than this. */
const RUNWAYS_M = 90;

const paths: Record<Projection, WeakMap<Cell, CellPaths>> = {
  geographic: new WeakMap(),
  mercator: new WeakMap(),
};

/** Sea, land, coast, borders and runways of a tile. `opacity` of sea and land: a picture of the Earth lies below. */
export function drawTile(
  context: Context,
  projection: Projection,
  frame: TileFrame,
  cells: readonly Cell[],
  look: GroundLook,
  opacity: number,
): void {
  context.globalAlpha = opacity;
  context.fillStyle = look.sea;
  context.fillRect(0, 0, WORLD_TILE_PX, WORLD_TILE_PX);
  const shallows_px = (2 * SHALLOWS_M) / frame.metresPerPixel;
  const hasShallows = opacity === 1 && shallows_px > SHALLOWS_PX[0] && shallows_px < SHALLOWS_PX[1];
  const drawn = cells.map((cell) => ({ cell, shapes: pathsOf(projection, cell) }));
  const each = (draw: (shapes: CellPaths, unit_px: number) => void): void => {
    for (const { cell, shapes } of drawn) {
      const unit_px = setPlace(context, projection, frame, cell);
      draw(shapes, unit_px);
    }
    context.resetTransform();
  };
  const stroke = (kind: "coast" | "borders", width_px: number): void =>
    each((shapes, unit_px) => {
      context.lineWidth = width_px / unit_px;
      context.stroke(nearTile(context, shapes[kind], width_px));
    });
  context.lineJoin = "round";
  context.lineCap = "round";
  if (hasShallows) {
    context.strokeStyle = look.shallows;
    stroke("coast", shallows_px);
  }
  context.fillStyle = look.land;
  each(({ land }) => context.fill(land, "evenodd"));
  context.globalAlpha = 1;
  context.strokeStyle = look.border;
  stroke("borders", BORDER_PX);
  context.strokeStyle = look.coast;
  stroke("coast", COAST_PX);
  if (frame.metresPerPixel < RUNWAYS_M) {
    drawRunways(context, projection, frame, cells, look);
  }
}

/** Airfields so far beyond a tile, degrees, may have a runway in it. */
const REACH_DEG = 0.08;

function drawRunways(
  context: Context,
  projection: Projection,
  frame: TileFrame,
  cells: readonly Cell[],
  look: GroundLook,
): void {
  const near = cells.flatMap(({ airfields }) => airfields.filter((airfield) => isNear(airfield, frame)));
  for (const runway of near.flatMap(({ runways }) => runways ?? [])) {
    const ends = (runway.places ?? []).map((place) => ({
      x: (place.longitude_deg - frame.west) / frame.pixel_deg,
      y: (frame.north - northing(projection, place.latitude_deg)) / frame.pixel_deg,
    }));
    drawRunway(context, runway, ends, look);
  }
}

function isNear({ longitude_deg, latitude_deg }: Position, { box }: TileFrame): boolean {
  return (
    longitude_deg > box.west_deg - 2 * REACH_DEG &&
    longitude_deg < box.east_deg + 2 * REACH_DEG &&
    latitude_deg > box.south_deg - REACH_DEG &&
    latitude_deg < box.north_deg + REACH_DEG
  );
}

/** Lets the context draw in the cell's units; returns the pixels of one. */
function setPlace(context: Context, projection: Projection, frame: TileFrame, { place }: Cell): number {
  const unit_px = place.size_deg / SHAPE_UNITS / frame.pixel_deg;
  context.setTransform(
    unit_px,
    0,
    0,
    -unit_px,
    (westOf(place) - frame.west) / frame.pixel_deg,
    (frame.north - northing(projection, southOf(place))) / frame.pixel_deg,
  );
  return unit_px;
}

function pathsOf(projection: Projection, cell: Cell): CellPaths {
  const known = paths[projection].get(cell);
  if (known !== undefined) {
    return known;
  }
  const upOf = upwards(projection, cell);
  const made = {
    land: filled(cell.land, upOf),
    coast: lines(cell.land, upOf, true),
    borders: lines(cell.borders, upOf, false),
  };
  paths[projection].set(cell, made);
  return made;
}

/** From a shape's y to the projection's, both in parts of the cell's width. */
function upwards(projection: Projection, { place }: Cell): (y: number) => number {
  if (projection === "geographic") {
    return (y) => y;
  }
  const unit_deg = place.size_deg / SHAPE_UNITS;
  const south = southOf(place);
  const origin = northing(projection, south);
  return (y) => (northing(projection, south + y * unit_deg) - origin) / unit_deg;
}

function filled({ points, starts }: Shapes, upOf: (y: number) => number): Path2D {
  const path = new Path2D();
  for (let shape = 0; shape + 1 < starts.length; shape += 1) {
    const [from = 0, to = 0] = [starts[shape], starts[shape + 1]];
    for (let point = from; point < to; point += 1) {
      path.lineTo(points[2 * point] ?? 0, upOf(points[2 * point + 1] ?? 0));
    }
    path.closePath();
    const next = starts[shape + 1] ?? 0;
    if (shape + 2 < starts.length) {
      path.moveTo(points[2 * next] ?? 0, upOf(points[2 * next + 1] ?? 0));
    }
  }
  return path;
}

/** The stretches that may be seen in the tile that the context draws, as one path. */
function nearTile(context: Context, stretches: readonly Stretch[], width_px: number): Path2D {
  const seen = context.getTransform().inverse();
  const low = seen.transformPoint({ x: -width_px, y: WORLD_TILE_PX + width_px });
  const high = seen.transformPoint({ x: WORLD_TILE_PX + width_px, y: -width_px });
  const path = new Path2D();
  for (const stretch of stretches) {
    if (stretch.west < high.x && stretch.east > low.x && stretch.south < high.y && stretch.north > low.y) {
      path.addPath(stretch.path);
    }
  }
  return path;
}

/** The shapes' lines; of closed rings without their edges along the cell's border, which were made by cutting. */
function lines({ points, starts }: Shapes, upOf: (y: number) => number, isClosed: boolean): Stretch[] {
  const stretches: Stretch[] = [];
  for (let shape = 0; shape + 1 < starts.length; shape += 1) {
    const [from = 0, to = 0] = [starts[shape], starts[shape + 1]];
    const line = points.subarray(2 * from, 2 * to);
    const edges = isClosed ? to - from : to - from - 1;
    for (let first = 0; first < edges; first += STRETCH) {
      stretches.push(stretchOf(line, first, Math.min(edges, first + STRETCH), upOf, isClosed));
    }
  }
  return stretches;
}

/** The edges of a line from one number up to another. */
function stretchOf(
  line: Int32Array,
  first: number,
  end: number,
  upOf: (y: number) => number,
  isClosed: boolean,
): Stretch {
  const path = new Path2D();
  const [xs, ys]: [number[], number[]] = [[], []];
  let isDown = false;
  for (let edge = first; edge < end; edge += 1) {
    const next = (2 * edge + 2) % line.length;
    const [x0 = 0, y0 = 0] = [line[2 * edge], line[2 * edge + 1]];
    const [x1 = 0, y1 = 0] = [line[next], line[next + 1]];
    if (isClosed && isCut(x0, y0, x1, y1)) {
      isDown = false;
      continue;
    }
    if (!isDown) {
      path.moveTo(x0, upOf(y0));
      isDown = true;
    }
    path.lineTo(x1, upOf(y1));
    xs.push(x0, x1);
    ys.push(upOf(y0), upOf(y1));
  }
  return {
    path,
    west: Math.min(...xs),
    east: Math.max(...xs),
    south: Math.min(...ys),
    north: Math.max(...ys),
  };
}

function isCut(x0: number, y0: number, x1: number, y1: number): boolean {
  return (x0 === x1 && (x0 === 0 || x0 === SHAPE_UNITS)) || (y0 === y1 && (y0 === 0 || y0 === SHAPE_UNITS));
}
