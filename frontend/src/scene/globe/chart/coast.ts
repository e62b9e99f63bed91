import { METRES_PER_DEGREE } from "../../../lib/geodesy";
import { COAST, LAND, SEA } from "../../colours";
import { type Box, boxOf, clipFilled, linesNear, overlaps, padded, type Ring, thinned } from "./geometry";

/** An island with its bounding box, so that most tiles need not examine its points. */
export interface Island {
  readonly ring: Ring;
  readonly box: Box;
}

/** The area of the chart over the Earth's image; transparent at its border. */
export const CHART: Box = { west_deg: -19.2, south_deg: 26.8, east_deg: -12.4, north_deg: 30.2 };
const BORDER_DEG = 0.7;

const SHALLOWS = ["rgb(120 185 205 / 16%)", "rgb(120 185 205 / 22%)"];
const SHALLOWS_M = [1500, 600];

/** GeoJSON polygons as islands. Throws on anything else. */
export function readIslands(text: string): readonly Island[] {
  const { features } = JSON.parse(text) as {
    features: readonly {
      readonly geometry: { readonly coordinates: readonly (readonly [number, number][])[] };
    }[];
  };
  return features.map(({ geometry }) => {
    // GeoJSON repeats the first point at the end.
    const ring = (geometry.coordinates[0] ?? []).slice(0, -1);
    return { ring, box: boxOf(ring) };
  });
}

/** Draw sea, land and coast of a tile onto a square canvas. */
export function drawCoast(context: CanvasRenderingContext2D, box: Box, islands: readonly Island[]): void {
  const size_px = context.canvas.width;
  const size_deg = box.east_deg - box.west_deg;
  const pixel_deg = size_deg / size_px;
  context.fillStyle = SEA;
  context.fillRect(0, 0, size_px, size_px);
  const widest_deg = (2 * (SHALLOWS_M[0] ?? 0)) / METRES_PER_DEGREE;
  const near = padded(box, Math.max(widest_deg, 4 * pixel_deg));
  const rings = islands
    .filter((island) => overlaps(island.box, near))
    .map(({ ring }) => thinned(ring, pixel_deg / 2));
  const trace = (points: Ring): void => {
    points.forEach(([longitude, latitude], index) => {
      const x = (longitude - box.west_deg) / pixel_deg;
      const y = (box.north_deg - latitude) / pixel_deg;
      if (index === 0) {
        context.moveTo(x, y);
      } else {
        context.lineTo(x, y);
      }
    });
  };
  context.lineJoin = "round";
  context.lineCap = "round";
  context.beginPath();
  for (const ring of rings) {
    for (const line of linesNear(ring, near)) {
      trace(line);
    }
  }
  SHALLOWS_M.forEach((metres, index) => {
    context.strokeStyle = SHALLOWS[index] ?? "";
    context.lineWidth = (2 * metres) / METRES_PER_DEGREE / pixel_deg;
    context.stroke();
  });
  context.fillStyle = LAND;
  context.beginPath();
  for (const ring of rings) {
    trace(clipFilled(ring, near));
    context.closePath();
  }
  context.fill();
  context.strokeStyle = COAST;
  context.lineWidth = 1.5;
  context.beginPath();
  for (const ring of rings) {
    for (const line of linesNear(ring, near)) {
      trace(line);
    }
  }
  context.stroke();
}

/** Fade the chart out at its border, where the Earth's image shows. */
export function fadeBorder(context: CanvasRenderingContext2D, box: Box): void {
  const size_px = context.canvas.width;
  const per_px = (box.east_deg - box.west_deg) / size_px;
  const east = (longitude_deg: number): number => (longitude_deg - box.west_deg) / per_px;
  const down = (latitude_deg: number): number => (box.north_deg - latitude_deg) / per_px;
  const border_px = BORDER_DEG / per_px;
  const sides = [
    [east(CHART.west_deg), 0, east(CHART.west_deg) + border_px, 0],
    [east(CHART.east_deg), 0, east(CHART.east_deg) - border_px, 0],
    [0, down(CHART.north_deg), 0, down(CHART.north_deg) + border_px],
    [0, down(CHART.south_deg), 0, down(CHART.south_deg) - border_px],
  ] as const;
  context.globalCompositeOperation = "destination-in";
  for (const [from_x, from_y, to_x, to_y] of sides) {
    const fade = context.createLinearGradient(from_x, from_y, to_x, to_y);
    fade.addColorStop(0, "rgb(0 0 0 / 0%)");
    fade.addColorStop(1, "rgb(0 0 0 / 100%)");
    context.fillStyle = fade;
    context.fillRect(0, 0, size_px, size_px);
  }
  context.globalCompositeOperation = "source-over";
}

/** Whether the soft border runs through a tile. */
export function needsFade(box: Box): boolean {
  const inner = padded(CHART, -BORDER_DEG);
  return !(
    box.west_deg >= inner.west_deg &&
    box.east_deg <= inner.east_deg &&
    box.south_deg >= inner.south_deg &&
    box.north_deg <= inner.north_deg
  );
}
