import type { Vector } from "./attitude";

/** Evenly spread directions: a spiral with the golden angle. */
export const DIRECTIONS: readonly Vector[] = spiral(80);

function spiral(count: number): Vector[] {
  const golden = Math.PI * (3 - Math.sqrt(5));
  return Array.from({ length: count }, (_, index) => {
    const z = 1 - (2 * index + 1) / count;
    const level = Math.sqrt(1 - z * z);
    return [level * Math.cos(index * golden), level * Math.sin(index * golden), z];
  });
}

/** Index of the nearest direction; null for a zero vector. */
export function nearestDirection([x, y, z]: Vector): number | null {
  if (!(x * x + y * y + z * z > 0)) {
    return null;
  }
  let best = 0;
  let most = Number.NEGATIVE_INFINITY;
  for (const [index, [a, b, c]] of DIRECTIONS.entries()) {
    const along = a * x + b * y + c * z;
    if (along > most) {
      [best, most] = [index, along];
    }
  }
  return best;
}

/** Number of points in each direction from the centre. */
export function cover(points: readonly Vector[], centre: Vector): number[] {
  const seen = new Array<number>(DIRECTIONS.length).fill(0);
  for (const [x, y, z] of points) {
    const nearest = nearestDirection([x - centre[0], y - centre[1], z - centre[2]]);
    if (nearest !== null) {
      seen[nearest] = (seen[nearest] ?? 0) + 1;
    }
  }
  return seen;
}

/** A side of the airframe. */
export const SIDES = ["nose", "tail", "right", "left", "belly", "top"] as const;
export type Side = (typeof SIDES)[number];

const SIDE_VECTORS: Readonly<Record<Side, Vector>> = {
  nose: [1, 0, 0],
  tail: [-1, 0, 0],
  right: [0, 1, 0],
  left: [0, -1, 0],
  belly: [0, 0, 1],
  top: [0, 0, -1],
};

/** The side with the most missing directions; null if none is missing. */
export function missingSide(seen: readonly number[]): Side | null {
  let worst: Side | null = null;
  let most = 0;
  for (const side of SIDES) {
    const [x, y, z] = SIDE_VECTORS[side];
    let missing = 0;
    for (const [index, [a, b, c]] of DIRECTIONS.entries()) {
      // Directions nearer to the side count more, those behind it not at all.
      missing += (seen[index] ?? 0) === 0 ? Math.max(0, a * x + b * y + c * z) ** 2 : 0;
    }
    if (missing > most + 1e-9) {
      [worst, most] = [side, missing];
    }
  }
  return worst;
}
