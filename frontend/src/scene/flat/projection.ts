import { EARTH_RADIUS_M, type Position } from "../../lib/geodesy";
import type { Box } from "../world/geometry";

/** A tile of level 0, which holds the whole map. */
export const TILE_PX = 256;
/** The square of Web Mercator ends here. */
const POLE_DEG = 85.0511;
/** So much of the map is taken by what all of it is to show; the rest is for names and buttons. */
const ROOM = 0.72;
export const ZOOMS = { least: 3, most: 20 } as const;

/** What a flat map shows: its middle, and how large. North is up; 256 pixels times two to `zoom` are the whole Earth. */
export interface FlatView {
  readonly centre: Position;
  readonly zoom: number;
  readonly width_px: number;
  readonly height_px: number;
}

export interface ScreenPoint {
  readonly x: number;
  readonly y: number;
}

/** Web Mercator, in which all tiles of pictures come: x from the date line east, y from the north, both 0..1. */
export function worldX(longitude_deg: number): number {
  return (longitude_deg + 180) / 360;
}

export function worldY(latitude_deg: number): number {
  const sine = Math.sin((Math.max(-POLE_DEG, Math.min(POLE_DEG, latitude_deg)) * Math.PI) / 180);
  return 0.5 - Math.log((1 + sine) / (1 - sine)) / (4 * Math.PI);
}

export function worldSize_px({ zoom }: FlatView): number {
  return TILE_PX * 2 ** zoom;
}

export function toScreen(view: FlatView, { latitude_deg, longitude_deg }: Position): ScreenPoint {
  const size = worldSize_px(view);
  return {
    x: (worldX(longitude_deg) - worldX(view.centre.longitude_deg)) * size + view.width_px / 2,
    y: (worldY(latitude_deg) - worldY(view.centre.latitude_deg)) * size + view.height_px / 2,
  };
}

export function fromScreen(view: FlatView, { x, y }: ScreenPoint): Position {
  const size = worldSize_px(view);
  const worldAtX = worldX(view.centre.longitude_deg) + (x - view.width_px / 2) / size;
  const worldAtY = worldY(view.centre.latitude_deg) + (y - view.height_px / 2) / size;
  const latitude = 2 * Math.atan(Math.exp(Math.PI * (1 - 2 * worldAtY))) - Math.PI / 2;
  return { latitude_deg: (latitude * 180) / Math.PI, longitude_deg: worldAtX * 360 - 180 };
}

/** All that is seen, and beyond the borders by so many pixels. */
export function boxSeen(view: FlatView, beyond_px = 0): Box {
  const low = fromScreen(view, { x: -beyond_px, y: view.height_px + beyond_px });
  const high = fromScreen(view, { x: view.width_px + beyond_px, y: -beyond_px });
  return {
    west_deg: low.longitude_deg,
    south_deg: low.latitude_deg,
    east_deg: high.longitude_deg,
    north_deg: high.latitude_deg,
  };
}

/** Metres of ground under one pixel in the middle. */
export function metresPerPixel(view: FlatView): number {
  const cosine = Math.cos((view.centre.latitude_deg * Math.PI) / 180);
  return (cosine * 2 * Math.PI * EARTH_RADIUS_M) / worldSize_px(view);
}

export function panned(view: FlatView, right_px: number, down_px: number): FlatView {
  const middle = { x: view.width_px / 2 + right_px, y: view.height_px / 2 + down_px };
  return { ...view, centre: fromScreen(view, middle) };
}

/** Larger by so many steps of two; what lies at `at` stays there. */
export function zoomed(view: FlatView, steps: number, at: ScreenPoint): FlatView {
  const zoom = Math.max(ZOOMS.least, Math.min(ZOOMS.most, view.zoom + steps));
  const held = fromScreen(view, at);
  const larger = { ...view, zoom };
  const moved = toScreen(larger, held);
  return panned(larger, moved.x - at.x, moved.y - at.y);
}

/** All of these places, with room around them; the same view where there is none. */
export function around(view: FlatView, places: readonly Position[]): FlatView {
  if (places.length === 0) {
    return view;
  }
  const xs = places.map(({ longitude_deg }) => worldX(longitude_deg));
  const ys = places.map(({ latitude_deg }) => worldY(latitude_deg));
  const [west, east, north, south] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
  const share = Math.max((east - west) / (ROOM * view.width_px), (south - north) / (ROOM * view.height_px));
  const zoom = share === 0 ? 15 : Math.min(16, Math.log2(1 / (share * TILE_PX)));
  const whole = { ...view, zoom, centre: { latitude_deg: 0, longitude_deg: 0 } };
  const size = worldSize_px(whole);
  const middle = {
    x: view.width_px / 2 + ((west + east) / 2 - 0.5) * size,
    y: view.height_px / 2 + ((north + south) / 2 - 0.5) * size,
  };
  return { ...whole, centre: fromScreen(whole, middle) };
}
