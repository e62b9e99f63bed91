import type { CellPlace, WorldLevel } from "./cell";
import type { Box } from "./geometry";
import { tileBox } from "./geometry";

/** The globe's tiles are squares of degrees; those of the flat map are of Web Mercator. */
export type Projection = "geographic" | "mercator";

/** One tile: x from the date line east, y from the north. */
export interface TilePlace {
  readonly projection: Projection;
  readonly level: number;
  readonly x: number;
  readonly y: number;
}

/** Where a tile's pixels are, in degrees east and in the projection's degrees north. */
export interface TileFrame {
  readonly west: number;
  readonly north: number;
  readonly pixel_deg: number;
  readonly box: Box;
  readonly metresPerPixel: number;
}

export const WORLD_TILE_PX = 256;
const METRES_PER_DEGREE = 111_195;
const RADIAN_DEG = 180 / Math.PI;
const MOST_DEG = 89.9;

/** From this many metres in a pixel on, a coarser level is as good. */
const COARSER_M = [450, 2500] as const;

/** The level whose shapes and names suit a picture with so many metres in a pixel. */
export function levelFor(metresPerPixel: number): WorldLevel {
  return metresPerPixel < COARSER_M[0] ? 2 : metresPerPixel < COARSER_M[1] ? 1 : 0;
}

/** Degrees north in the projection. */
export function northing(projection: Projection, latitude_deg: number): number {
  if (projection === "geographic") {
    return latitude_deg;
  }
  const latitude = Math.max(-MOST_DEG, Math.min(MOST_DEG, latitude_deg)) / RADIAN_DEG;
  return Math.log(Math.tan(Math.PI / 4 + latitude / 2)) * RADIAN_DEG;
}

export function frameOf({ projection, level, x, y }: TilePlace): TileFrame {
  if (projection === "geographic") {
    const box = tileBox(level, x, y);
    const pixel_deg = (box.east_deg - box.west_deg) / WORLD_TILE_PX;
    return {
      west: box.west_deg,
      north: box.north_deg,
      pixel_deg,
      box,
      metresPerPixel: pixel_deg * METRES_PER_DEGREE,
    };
  }
  const size_deg = 360 / 2 ** level;
  const [west, north] = [x * size_deg - 180, 180 - y * size_deg];
  const latitude = (northing_deg: number): number =>
    (2 * Math.atan(Math.exp(northing_deg / RADIAN_DEG)) - Math.PI / 2) * RADIAN_DEG;
  const box = {
    west_deg: west,
    east_deg: west + size_deg,
    north_deg: latitude(north),
    south_deg: latitude(north - size_deg),
  };
  const pixel_deg = size_deg / WORLD_TILE_PX;
  const middle = (box.north_deg + box.south_deg) / 2;
  return {
    west,
    north,
    pixel_deg,
    box,
    metresPerPixel: pixel_deg * METRES_PER_DEGREE * Math.cos(middle / RADIAN_DEG),
  };
}

/** The cells of a level that a box touches; those beyond the date line are left out. */
export function cellsOf(level: WorldLevel, size_deg: number, box: Box): CellPlace[] {
  const [columns, rows] = [Math.round(360 / size_deg), Math.round(180 / size_deg)];
  const column = (longitude_deg: number): number =>
    Math.max(0, Math.min(columns - 1, Math.floor((longitude_deg + 180) / size_deg)));
  const row = (latitude_deg: number): number =>
    Math.max(0, Math.min(rows - 1, Math.floor((latitude_deg + 90) / size_deg)));
  const cells: CellPlace[] = [];
  for (let at = column(box.west_deg); at <= column(box.east_deg); at += 1) {
    for (let up = row(box.south_deg); up <= row(box.north_deg); up += 1) {
      cells.push({ level, column: at, row: up, size_deg });
    }
  }
  return cells;
}
