import type { Light } from "../look";
import type { VectorFeature, VectorLayer } from "./vectorTile";

/** What a feature is drawn as, whatever its source calls it. */
type FeatureStyle =
  | "green"
  | "built"
  | "water"
  | "river"
  | "building"
  | "rail"
  | "path"
  | "street"
  | "road"
  | "motorway";

const ORDER: readonly FeatureStyle[] = [
  "green",
  "built",
  "water",
  "river",
  "building",
  "path",
  "rail",
  "street",
  "road",
  "motorway",
];

interface Ink {
  readonly fill?: string;
  readonly line?: string;
  /** Pixels at level 14; half as wide two levels above, down to a hairline. */
  readonly width_px?: number;
  readonly edge?: string;
  readonly dash?: readonly number[];
}

const INKS: Readonly<Record<Light, Readonly<Record<FeatureStyle, Ink>>>> = {
  day: {
    green: { fill: "rgb(70 120 60 / 25%)" },
    built: { fill: "rgb(120 110 100 / 25%)" },
    water: { fill: "#3f7fb0" },
    river: { line: "#3f7fb0", width_px: 2 },
    building: { fill: "#5f5850", line: "#3c3833", width_px: 0.6 },
    path: { line: "#5a4a3a", width_px: 1, dash: [4, 3] },
    rail: { line: "#2c2c34", width_px: 1.6, dash: [7, 4] },
    street: { line: "#f4f1e6", width_px: 2, edge: "#4b463c" },
    road: { line: "#ffe08a", width_px: 3, edge: "#4b3d18" },
    motorway: { line: "#ff9d5c", width_px: 4, edge: "#4f2410" },
  },
  night: {
    green: { fill: "rgb(30 60 30 / 30%)" },
    built: { fill: "rgb(70 70 76 / 25%)" },
    water: { fill: "#12304a" },
    river: { line: "#1d4566", width_px: 2 },
    building: { fill: "#383a3e", line: "#50545a", width_px: 0.6 },
    path: { line: "#6b6154", width_px: 1, dash: [4, 3] },
    rail: { line: "#7b7f8a", width_px: 1.6, dash: [7, 4] },
    street: { line: "#6e7176", width_px: 2, edge: "#14171a" },
    road: { line: "#9a8650", width_px: 3, edge: "#14171a" },
    motorway: { line: "#a3683e", width_px: 4, edge: "#14171a" },
  },
};

/** Names of OpenMapTiles, Protomaps and Shortbread. */
const LAYERS: Readonly<Record<string, (feature: VectorFeature) => FeatureStyle | null>> = {
  transportation: wayOf,
  roads: wayOf,
  streets: wayOf,
  water: (feature) => (feature.kind === "line" ? "river" : "water"),
  ocean: () => "water",
  water_polygons: () => "water",
  waterway: () => "river",
  physical_line: () => "river",
  water_lines: () => "river",
  building: () => "building",
  buildings: () => "building",
  landcover: () => "green",
  park: () => "green",
  landuse: landOf,
  land: landOf,
};

const NAMED: ReadonlySet<string> = new Set([
  "transportation_name",
  "street_labels",
  "roads",
  "waterway",
  "water_lines",
  "water_lines_labels",
  "physical_line",
]);

export function isDrawnLayer(name: string): boolean {
  return Object.hasOwn(LAYERS, name) || NAMED.has(name);
}

function wayOf({ tags }: VectorFeature): FeatureStyle | null {
  const said = `${tags.get("class") ?? ""} ${tags.get("pmap:kind") ?? ""} ${tags.get("kind") ?? ""}`;
  if (/motorway|trunk|highway/.test(said)) return "motorway";
  if (/primary|secondary|major_road/.test(said)) return "road";
  if (/rail|transit|tram/.test(said)) return "rail";
  if (/path|track|footway|cycleway|steps|pedestrian/.test(said)) return "path";
  return /ferry|aeroway|runway|taxiway/.test(said) ? null : "street";
}

function landOf({ tags }: VectorFeature): FeatureStyle | null {
  const said = `${tags.get("class") ?? ""} ${tags.get("pmap:kind") ?? ""} ${tags.get("kind") ?? ""}`;
  if (/wood|forest|grass|park|meadow|scrub|farm|orchard|vineyard|garden/.test(said)) return "green";
  return /residential|commercial|industrial|retail|urban/.test(said) ? "built" : null;
}

/** A part of a tile: shares of its side, drawn over the whole canvas. */
export interface TilePart {
  readonly left: number;
  readonly top: number;
  readonly share: number;
}

type Canvas = Pick<
  CanvasRenderingContext2D,
  | "beginPath"
  | "moveTo"
  | "lineTo"
  | "fill"
  | "stroke"
  | "setLineDash"
  | "fillStyle"
  | "strokeStyle"
  | "lineWidth"
  | "lineJoin"
  | "lineCap"
>;

/** Draw a part of a tile over a canvas of this size. `zoom`: of what is seen, which may be finer than the tile. */
export function drawVector(
  context: Canvas,
  layers: readonly VectorLayer[],
  part: TilePart,
  size_px: number,
  zoom: number,
  light: Light,
): void {
  const sorted = sortedOf(layers);
  context.lineJoin = "round";
  context.lineCap = "round";
  for (const drawn of ORDER) {
    const features = sorted.get(drawn) ?? [];
    if (features.length > 0) {
      drawAll(context, features, INKS[light][drawn], part, size_px, zoom);
    }
  }
}

function sortedOf(layers: readonly VectorLayer[]): ReadonlyMap<FeatureStyle, readonly VectorFeature[]> {
  const sorted = new Map<FeatureStyle, VectorFeature[]>(ORDER.map((drawn) => [drawn, []]));
  for (const { name, features } of layers) {
    // A stranger's layer may be called like a property that every object has.
    const drawnAs = Object.hasOwn(LAYERS, name) ? LAYERS[name] : undefined;
    for (const feature of drawnAs === undefined ? [] : features) {
      const drawn = feature.kind === "point" ? null : drawnAs?.(feature);
      if (drawn != null) sorted.get(drawn)?.push(feature);
    }
  }
  return sorted;
}

function drawAll(
  context: Canvas,
  features: readonly VectorFeature[],
  { fill, line, width_px = 1, edge, dash = [] }: Ink,
  part: TilePart,
  size_px: number,
  zoom: number,
): void {
  const areas = features.filter(({ kind }) => kind === "area");
  if (fill !== undefined && areas.length > 0) {
    context.fillStyle = fill;
    for (const area of areas) {
      trace(context, area, part, size_px);
      context.fill("evenodd");
    }
  }
  if (line === undefined) return;
  const wide_px = Math.max(0.5, width_px * 2 ** ((zoom - 14) / 2));
  context.setLineDash([...dash]);
  for (const [colour, width] of edge === undefined
    ? [[line, wide_px] as const]
    : [[edge, wide_px + 1.6] as const, [line, wide_px] as const]) {
    context.strokeStyle = colour;
    context.lineWidth = width;
    for (const feature of features) {
      trace(context, feature, part, size_px);
      context.stroke();
    }
  }
  context.setLineDash([]);
}

function trace(
  context: Canvas,
  { shapes }: VectorFeature,
  { left, top, share }: TilePart,
  size_px: number,
): void {
  context.beginPath();
  for (const shape of shapes) {
    for (let index = 0; index + 1 < shape.length; index += 2) {
      const x = (((shape[index] ?? 0) - left) / share) * size_px;
      const y = (((shape[index + 1] ?? 0) - top) / share) * size_px;
      if (index === 0) context.moveTo(x, y);
      else context.lineTo(x, y);
    }
  }
}

/** The name of a way, and where its middle is in the tile. */
export interface VectorName {
  readonly text: string;
  readonly kind: "road" | "water";
  /** Of more than one the higher is shown. */
  readonly rank: number;
  readonly x: number;
  readonly y: number;
}

const MOST_NAMES = 40;

/** The names in a part of a tile, each once, the most important first. */
export function namesOf(layers: readonly VectorLayer[], part: TilePart): VectorName[] {
  const found = new Map<string, VectorName & { readonly length: number }>();
  for (const { name, features } of layers) {
    const kind = /water|physical/.test(name) ? "water" : "road";
    for (const feature of NAMED.has(name) ? features : []) {
      const named = nameOf(feature, kind, part);
      if (named !== null && named.length > (found.get(named.text)?.length ?? 0)) {
        found.set(named.text, named);
      }
    }
  }
  return [...found.values()]
    .sort((one, other) => other.rank - one.rank || other.length - one.length)
    .slice(0, MOST_NAMES)
    .map(({ text, kind, rank, x, y }) => ({ text, kind, rank, x, y }));
}

/** Null without a name, or where its middle is not in this part. `length`: of its longest line, in numbers. */
function nameOf(
  feature: VectorFeature,
  kind: VectorName["kind"],
  { left, top, share }: TilePart,
): (VectorName & { readonly length: number }) | null {
  const { tags, shapes } = feature;
  const ref = kind === "road" ? tags.get("ref") : undefined;
  const text = ref ?? tags.get("name") ?? tags.get("name:latin") ?? "";
  const line = shapes.reduce<readonly number[]>((best, one) => (one.length > best.length ? one : best), []);
  const middle = Math.floor(line.length / 4) * 2;
  const [x, y] = [line[middle], line[middle + 1]];
  if (text === "" || feature.kind === "area" || x === undefined || y === undefined) {
    return null;
  }
  const isHere = x >= left && y >= top && x < left + share && y < top + share;
  return isHere ? { text, kind, rank: rankOf(feature, kind), x, y, length: line.length } : null;
}

function rankOf(feature: VectorFeature, kind: VectorName["kind"]): number {
  if (kind === "water") return 2;
  const drawn = wayOf(feature);
  return drawn === "motorway" ? 4 : drawn === "road" ? 3 : 1;
}
