/** A part of the map in degrees; longitudes are used as plain numbers, so it does not cross the antimeridian. */
export interface Box {
  readonly west_deg: number;
  readonly south_deg: number;
  readonly east_deg: number;
  readonly north_deg: number;
}

/** The box of a tile: two tiles on level 0, each half as wide on the next; x from the west, y from the north. */
export function tileBox(level: number, x: number, y: number): Box {
  const size_deg = 180 / 2 ** level;
  const west_deg = -180 + x * size_deg;
  const north_deg = 90 - y * size_deg;
  return { west_deg, north_deg, east_deg: west_deg + size_deg, south_deg: north_deg - size_deg };
}

/** Longitude and latitude, degrees. */
type Point = readonly [longitude_deg: number, latitude_deg: number];

/** Whether two boxes have a point in common. */
export function overlaps(one: Box, other: Box): boolean {
  return (
    one.west_deg <= other.east_deg &&
    other.west_deg <= one.east_deg &&
    one.south_deg <= other.north_deg &&
    other.south_deg <= one.north_deg
  );
}

export function boxOf(points: readonly Point[]): Box {
  const longitudes = points.map(([longitude]) => longitude);
  const latitudes = points.map(([, latitude]) => latitude);
  return {
    west_deg: Math.min(...longitudes),
    south_deg: Math.min(...latitudes),
    east_deg: Math.max(...longitudes),
    north_deg: Math.max(...latitudes),
  };
}
