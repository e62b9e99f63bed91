/** A part of the map in degrees; longitudes are used as plain numbers, so it does not cross the antimeridian. */
export interface Box {
  readonly west_deg: number;
  readonly south_deg: number;
  readonly east_deg: number;
  readonly north_deg: number;
}

/** Longitude and latitude, degrees. */
export type Point = readonly [longitude_deg: number, latitude_deg: number];
/** A closed line; its last point is not the first one repeated. */
export type Ring = readonly Point[];

/** The box of a tile: two tiles on level 0, each half as wide on the next; x from the west, y from the north. */
export function tileBox(level: number, x: number, y: number): Box {
  const size_deg = 180 / 2 ** level;
  const west_deg = -180 + x * size_deg;
  const north_deg = 90 - y * size_deg;
  return { west_deg, north_deg, east_deg: west_deg + size_deg, south_deg: north_deg - size_deg };
}

export function padded(box: Box, by_deg: number): Box {
  return {
    west_deg: box.west_deg - by_deg,
    south_deg: box.south_deg - by_deg,
    east_deg: box.east_deg + by_deg,
    north_deg: box.north_deg + by_deg,
  };
}

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

interface Edge {
  readonly isInside: (point: Point) => boolean;
  /** Where the line from the one to the other crosses it. */
  readonly cross: (from: Point, to: Point) => Point;
}

function edgesOf(box: Box): readonly Edge[] {
  const atLongitude =
    (longitude: number) =>
    (from: Point, to: Point): Point => [
      longitude,
      from[1] + ((longitude - from[0]) / (to[0] - from[0])) * (to[1] - from[1]),
    ];
  const atLatitude =
    (latitude: number) =>
    (from: Point, to: Point): Point => [
      from[0] + ((latitude - from[1]) / (to[1] - from[1])) * (to[0] - from[0]),
      latitude,
    ];
  return [
    { isInside: ([longitude]) => longitude >= box.west_deg, cross: atLongitude(box.west_deg) },
    { isInside: ([longitude]) => longitude <= box.east_deg, cross: atLongitude(box.east_deg) },
    { isInside: ([, latitude]) => latitude >= box.south_deg, cross: atLatitude(box.south_deg) },
    { isInside: ([, latitude]) => latitude <= box.north_deg, cross: atLatitude(box.north_deg) },
  ];
}

/** The part of a filled ring inside a box; may be empty. Its edges along the box are no coast. */
export function clipFilled(ring: Ring, box: Box): Ring {
  let clipped: Point[] = [...ring];
  for (const { isInside, cross } of edgesOf(box)) {
    const before = clipped;
    clipped = [];
    before.forEach((point, index) => {
      const previous = before.at(index - 1) ?? point;
      if (isInside(point) !== isInside(previous)) {
        clipped.push(cross(previous, point));
      }
      if (isInside(point)) {
        clipped.push(point);
      }
    });
  }
  return clipped;
}

/** The lines of a ring that may be visible in a box, each with its neighbours just outside, so that no end shows. */
export function linesNear(ring: Ring, box: Box): readonly (readonly Point[])[] {
  const lines: Point[][] = [];
  let line: Point[] | null = null;
  ring.forEach((point, index) => {
    const next = ring[(index + 1) % ring.length] ?? point;
    if (!overlaps(boxOf([point, next]), box)) {
      line = null;
      return;
    }
    if (line === null) {
      line = [point];
      lines.push(line);
    }
    line.push(next);
  });
  return lines;
}

/** A ring without points nearer than `least_deg` to the last kept one: for small scales. */
export function thinned(ring: Ring, least_deg: number): Ring {
  let kept: Point | null = null;
  return ring.filter((point) => {
    if (kept !== null && Math.hypot(point[0] - kept[0], point[1] - kept[1]) < least_deg) {
      return false;
    }
    kept = point;
    return true;
  });
}

/** Metres of a degree of longitude and of latitude at a latitude, on the WGS 84 ellipsoid. */
export function metresOfDegree(latitude_deg: number): { longitude_m: number; latitude_m: number } {
  const angle = (latitude_deg * Math.PI) / 180;
  return {
    longitude_m: 111_412.84 * Math.cos(angle) - 93.5 * Math.cos(3 * angle) + 0.118 * Math.cos(5 * angle),
    latitude_m: 111_132.92 - 559.82 * Math.cos(2 * angle) + 1.175 * Math.cos(4 * angle),
  };
}
