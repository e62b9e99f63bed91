import type { Position } from "./geodesy";

type Flat = readonly [x: number, y: number];

/**
 * Two sides of a fence's border that cross or touch, by index from 0 (side n begins at corner n); null if none do. Of a
 * border that crosses itself it is not clear what is inside, so that it cannot be kept.
 */
export function crossingSides(corners: readonly Position[]): readonly [number, number] | null {
  const places = flat(corners, corners);
  if (places.length < 3) {
    return null;
  }
  const sides = places.map((from, nth) => [from, places[(nth + 1) % places.length] ?? from] as const);
  for (const [nth, side] of sides.entries()) {
    for (const [other, against] of sides.entries()) {
      const areNeighbours = other === nth + 1 || (nth === 0 && other === sides.length - 1);
      if (other > nth && (areNeighbours ? fold(...side, ...against) : meet(...side, ...against))) {
        return [nth, other];
      }
    }
  }
  return null;
}

/** Whether a place lies inside the border; twice enclosed counts as outside. */
export function isInside(corners: readonly Position[], place: Position): boolean {
  const border = flat(corners, corners);
  const [[x, y] = [0, 0]] = flat(corners, [place]);
  let inside = false;
  for (const [nth, [x1, y1]] of border.entries()) {
    const [x2, y2] = border[(nth + 1) % border.length] ?? [x1, y1];
    if (y1 > y !== y2 > y && x < x1 + ((y - y1) / (y2 - y1)) * (x2 - x1)) {
      inside = !inside;
    }
  }
  return inside;
}

/** Whether the straight way between two places crosses or touches the border. */
export function crosses(corners: readonly Position[], from: Position, to: Position): boolean {
  const border = flat(corners, corners);
  const [start, end] = flat(corners, [from, to]);
  return border.some((corner, nth) => {
    const next = border[(nth + 1) % border.length];
    return start !== undefined && end !== undefined && next !== undefined && meet(start, end, corner, next);
  });
}

/** Places in one plane; longitudes count from the border's first corner, so that no border has a seam in it. */
function flat(corners: readonly Position[], places: readonly Position[]): readonly Flat[] {
  const first_deg = corners[0]?.longitude_deg ?? 0;
  return places.map(({ latitude_deg, longitude_deg }) => [
    (((longitude_deg - first_deg + 180) % 360) + 360) % 360,
    latitude_deg,
  ]);
}

function meet(a: Flat, b: Flat, c: Flat, d: Flat): boolean {
  const [c_, d_, a_, b_] = [turn(a, b, c), turn(a, b, d), turn(c, d, a), turn(c, d, b)];
  return (
    (c_ * d_ < 0 && a_ * b_ < 0) ||
    (c_ === 0 && isBetween(a, b, c)) ||
    (d_ === 0 && isBetween(a, b, d)) ||
    (a_ === 0 && isBetween(c, d, a)) ||
    (b_ === 0 && isBetween(c, d, b))
  );
}

/** Of two sides that share an end: whether one lies on the other, as those of a spike do. */
function fold(a: Flat, b: Flat, c: Flat, d: Flat): boolean {
  const isStraight = turn(a, b, c) === 0 && turn(a, b, d) === 0;
  const ends = [isBetween(a, b, c), isBetween(a, b, d), isBetween(c, d, a), isBetween(c, d, b)];
  return isStraight && ends.filter(Boolean).length > 2;
}

function turn(a: Flat, b: Flat, c: Flat): number {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

function isBetween(a: Flat, b: Flat, c: Flat): boolean {
  return [0, 1].every((axis) => {
    const [from, to, at] = [a[axis] ?? 0, b[axis] ?? 0, c[axis] ?? 0];
    return Math.min(from, to) <= at && at <= Math.max(from, to);
  });
}
