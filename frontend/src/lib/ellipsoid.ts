import type { Vector } from "./attitude";
import { eigen3, leastSquares, type Matrix3, spectral3, times3 } from "./linear";
import { cover } from "./sphereCover";

/**
 * Corrects raw readings: `matrix` times (reading - `offset`) has the length `radius` for every reading. The matrix is
 * symmetric with determinant one; for a sphere it is the identity.
 */
export interface FieldFit {
  readonly kind: "ellipsoid" | "sphere";
  readonly offset: Vector;
  readonly matrix: Matrix3;
  readonly radius: number;
  /** Root mean square of the lengths' errors, in the readings' own unit. */
  readonly residual: number;
  readonly used: number;
  readonly rejected: number;
  /** Share of all directions that have readings, 0..1. */
  readonly coverage: number;
}

/** Why there is no fit: too few readings, from too few directions, or not on a closed surface. */
export type FitRefusal = "tooFew" | "notCovered" | "notClosed";

export type FitAnswer =
  | FieldFit
  | { readonly kind: "refused"; readonly why: FitRefusal; readonly coverage: number };

/** Below the first coverage there is no fit; from the second on an ellipsoid is fitted; between them a sphere. */
export const SPHERE_COVERAGE = 0.3;
export const ELLIPSOID_COVERAGE = 0.65;
const LEAST_POINTS = 40;
/** A reading whose error is this many times the usual one is rejected as an outlier. */
const OUTLIER_SIGMAS = 4;
/** Standard deviation of normal noise, per median of the absolute errors. */
const SIGMA_PER_MEDIAN = 1.4826;
/** Smallest assumed error: without it a perfect sphere would reject its own rounding errors. */
const LEAST_SIGMA = 1e-3;
const PASSES = 4;
const STEPS = 8;
/** The scales of a real magnetometer's axes differ by tens of per cent; a larger ratio is no fit. */
const MOST_STRETCH = 4;

const IDENTITY: Matrix3 = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
];

/** The sphere or ellipsoid on which these readings lie. */
export function fitField(readings: readonly Vector[]): FitAnswer {
  const points = readings.filter((reading) => reading.every(Number.isFinite));
  if (points.length < LEAST_POINTS) {
    return { kind: "refused", why: "tooFew", coverage: 0 };
  }
  const sphere = robust(points, fitSphere);
  if (sphere === null) {
    return { kind: "refused", why: "notClosed", coverage: 0 };
  }
  const rough = coverageOf(points, sphere.offset);
  const ellipsoid = rough >= SPHERE_COVERAGE ? robust(points, fitEllipsoid) : null;
  // Measured from the better centre: a large offset makes the sphere's centre inaccurate.
  const coverage = ellipsoid === null ? rough : coverageOf(points, ellipsoid.offset);
  if (coverage < SPHERE_COVERAGE) {
    return { kind: "refused", why: "notCovered", coverage };
  }
  if (ellipsoid !== null && coverage >= ELLIPSOID_COVERAGE) {
    return { kind: "ellipsoid", ...ellipsoid, coverage };
  }
  return rough < SPHERE_COVERAGE
    ? { kind: "refused", why: "notCovered", coverage: rough }
    : { kind: "sphere", ...sphere, coverage: rough };
}

/** A corrected reading, in the readings' own unit. */
export function corrected({ offset, matrix }: FieldFit, [x, y, z]: Vector): Vector {
  return times3(matrix, [x - offset[0], y - offset[1], z - offset[2]]);
}

export function coverageOf(points: readonly Vector[], centre: Vector): number {
  const seen = cover(points, centre);
  return seen.filter((count) => count > 0).length / seen.length;
}

interface Shape {
  readonly offset: Vector;
  readonly matrix: Matrix3;
  readonly radius: number;
}

type Fit = (points: readonly Vector[]) => Shape | null;
type Robust = Shape & Pick<FieldFit, "residual" | "used" | "rejected">;

/** Fit, reject outliers, and repeat until nothing changes. */
function robust(points: readonly Vector[], find: Fit): Robust | null {
  let kept = points;
  let shape: Shape | null = null;
  for (let pass = 0; pass < PASSES; pass += 1) {
    shape = find(kept);
    if (shape === null) {
      return null;
    }
    const errors = errorsOf(shape, points);
    const sizes = errors.map(Math.abs).sort((one, other) => one - other);
    const median = sizes[Math.floor(sizes.length / 2)] ?? 0;
    const limit = OUTLIER_SIGMAS * Math.max(LEAST_SIGMA * shape.radius, SIGMA_PER_MEDIAN * median);
    const next = points.filter((_, index) => Math.abs(errors[index] ?? 0) <= limit);
    if (next.length === kept.length || next.length < LEAST_POINTS) {
      break;
    }
    kept = next;
  }
  if (shape === null) {
    return null;
  }
  const errors = errorsOf(shape, kept);
  const residual = Math.sqrt(errors.reduce((sum, error) => sum + error * error, 0) / kept.length);
  return { ...shape, residual, used: kept.length, rejected: points.length - kept.length };
}

function errorsOf({ offset, matrix, radius }: Shape, points: readonly Vector[]): number[] {
  return points.map(
    ([x, y, z]) => Math.hypot(...times3(matrix, [x - offset[0], y - offset[1], z - offset[2]])) - radius,
  );
}

/** Points moved to their mean and scaled to a mean distance of one, so that the unknowns have similar sizes. */
function normalised(points: readonly Vector[]): { mean: Vector; scale: number; unit: Vector[] } | null {
  const mean = [0, 1, 2].map(
    (axis) => points.reduce((sum, point) => sum + (point[axis] ?? 0), 0) / points.length,
  );
  const [mx = 0, my = 0, mz = 0] = mean;
  const scale =
    points.reduce((sum, [x, y, z]) => sum + Math.hypot(x - mx, y - my, z - mz), 0) / points.length;
  if (!(scale > 0)) {
    return null;
  }
  return {
    mean: [mx, my, mz],
    scale,
    unit: points.map(([x, y, z]) => [(x - mx) / scale, (y - my) / scale, (z - mz) / scale]),
  };
}

/** x·x - 2 c·x = r² - c·c is linear in the centre and in the right-hand side. */
function fitSphere(points: readonly Vector[]): Shape | null {
  const moved = normalised(points);
  if (moved === null) {
    return null;
  }
  const found = leastSquares(
    moved.unit.map(([x, y, z]) => [2 * x, 2 * y, 2 * z, 1]),
    moved.unit.map(([x, y, z]) => x * x + y * y + z * z),
  );
  if (found === null) {
    return null;
  }
  const [cx = 0, cy = 0, cz = 0, rest = 0] = found;
  const square = rest + cx * cx + cy * cy + cz * cz;
  if (!(square > 0) || !Number.isFinite(square)) {
    return null;
  }
  return {
    offset: back(moved, [cx, cy, cz]),
    matrix: IDENTITY,
    radius: moved.scale * Math.sqrt(square),
  };
}

/** Start from a general quadric, then refine the lengths' errors, which noise does not bias inwards. */
function fitEllipsoid(points: readonly Vector[]): Shape | null {
  const moved = normalised(points);
  const start = moved === null ? null : quadric(moved.unit);
  if (moved === null || start === null) {
    return null;
  }
  const shape = refined(moved.unit, start);
  if (shape === null) {
    return null;
  }
  const { values } = eigen3(shape.matrix);
  const size = Math.cbrt(values[0] * values[1] * values[2]);
  const [least, most] = [Math.min(...values), Math.max(...values)];
  if (!(least > 0) || !Number.isFinite(size) || most / least > MOST_STRETCH) {
    return null;
  }
  return {
    offset: back(moved, shape.centre),
    matrix: spectral3(shape.matrix, (value) => value / size),
    radius: moved.scale / size,
  };
}

function back({ mean, scale }: { mean: Vector; scale: number }, [x, y, z]: Vector): Vector {
  return [mean[0] + scale * x, mean[1] + scale * y, mean[2] + scale * z];
}

/** |matrix (x - centre)| = 1. */
interface UnitShape {
  readonly centre: Vector;
  readonly matrix: Matrix3;
}

function symmetric([a = 0, b = 0, c = 0, d = 0, e = 0, f = 0]: readonly number[]): Matrix3 {
  return [
    [a, d, e],
    [d, b, f],
    [e, f, c],
  ];
}

function quadric(points: readonly Vector[]): UnitShape | null {
  const found = leastSquares(
    points.map(([x, y, z]) => [x * x, y * y, z * z, 2 * x * y, 2 * x * z, 2 * y * z, 2 * x, 2 * y, 2 * z]),
    points.map(() => 1),
  );
  if (found === null) {
    return null;
  }
  const form = symmetric(found);
  const linear: Vector = [found[6] ?? 0, found[7] ?? 0, found[8] ?? 0];
  const { values } = eigen3(form);
  if (values.some((value) => !(value > 0))) {
    return null;
  }
  const [cx, cy, cz] = times3(
    spectral3(form, (value) => 1 / value),
    linear,
  );
  const centre: Vector = [-cx, -cy, -cz];
  const level = 1 + linear[0] * cx + linear[1] * cy + linear[2] * cz;
  return level > 0 ? { centre, matrix: spectral3(form, (value) => Math.sqrt(value / level)) } : null;
}

/** Gauss-Newton steps on the nine unknowns of |M (x - c)| = 1. */
function refined(points: readonly Vector[], start: UnitShape): UnitShape | null {
  let { centre, matrix } = start;
  for (let step = 0; step < STEPS; step += 1) {
    const rows: number[][] = [];
    const errors: number[] = [];
    for (const [px, py, pz] of points) {
      const [x, y, z] = [px - centre[0], py - centre[1], pz - centre[2]];
      const [u, v, w] = times3(matrix, [x, y, z]);
      const length = Math.hypot(u, v, w) || 1;
      const [a, b, c] = [u / length, v / length, w / length];
      // The matrix is its own transpose, so the derivative by the centre is the matrix times the direction.
      const [dx, dy, dz] = times3(matrix, [a, b, c]);
      rows.push([a * x, b * y, c * z, a * y + b * x, a * z + c * x, b * z + c * y, -dx, -dy, -dz]);
      errors.push(1 - length);
    }
    const change = leastSquares(rows, errors);
    if (change === null) {
      return null;
    }
    const old = [matrix[0][0], matrix[1][1], matrix[2][2], matrix[0][1], matrix[0][2], matrix[1][2]];
    matrix = symmetric(old.map((value, index) => value + (change[index] ?? 0)));
    centre = [centre[0] + (change[6] ?? 0), centre[1] + (change[7] ?? 0), centre[2] + (change[8] ?? 0)];
    const size = Math.hypot(...change);
    if (!Number.isFinite(size) || size < 1e-10) {
      break;
    }
  }
  return [...centre, ...matrix.flat()].every(Number.isFinite) ? { centre, matrix } : null;
}
