import { describe, expect, test } from "vitest";
import type { Vector } from "./attitude";
import { corrected, type FieldFit, type FitAnswer, fitField } from "./ellipsoid";
import { eigen3, leastSquares, type Matrix3, spectral3, times3 } from "./linear";
import { DIRECTIONS, missingSide } from "./sphereCover";

/** Reproducible pseudo-random numbers, evenly in 0..1. */
function numbers(seed: number): () => number {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1_664_525) + 1_013_904_223) >>> 0;
    return (state + 0.5) / 2 ** 32;
  };
}

function normal(random: () => number): number {
  return Math.sqrt(-2 * Math.log(random())) * Math.cos(2 * Math.PI * random());
}

const OFFSET: Vector = [0.35, -0.22, 0.61];
const SPHERE: Matrix3 = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
];
/** Scales of 0.8, 1.1 and 1.25 along axes that are not the board's. */
const BENT = spectral3(
  [
    [1.0, 0.15, -0.1],
    [0.15, 1.1, 0.08],
    [-0.1, 0.08, 0.95],
  ],
  (value) => value,
);

interface Example {
  readonly count?: number;
  readonly noise?: number;
  readonly shape?: Matrix3;
  /** Only directions for which this holds. */
  readonly where?: (direction: Vector) => boolean;
  readonly offset?: Vector;
  readonly seed?: number;
}

/** Readings of a field of one, seen from everywhere, through a sensor with this shape and offset. */
function readings(made: Example = {}): Vector[] {
  const { count = 600, noise = 0.005, shape = BENT, where = () => true, offset = OFFSET, seed = 7 } = made;
  const random = numbers(seed);
  const found: Vector[] = [];
  while (found.length < count) {
    const [a, b, c] = [normal(random), normal(random), normal(random)];
    const length = Math.hypot(a, b, c);
    const direction: Vector = [a / length, b / length, c / length];
    if (where(direction)) {
      const [x, y, z] = times3(shape, direction);
      found.push([
        x + offset[0] + noise * normal(random),
        y + offset[1] + noise * normal(random),
        z + offset[2] + noise * normal(random),
      ]);
    }
  }
  return found;
}

function fitted(answer: FitAnswer): FieldFit {
  if (answer.kind === "refused") {
    throw new Error(`refused: ${answer.why}`);
  }
  return answer;
}

function farthest(found: Vector, wanted: Vector): number {
  return Math.max(...found.map((value, axis) => Math.abs(value - (wanted[axis] ?? 0))));
}

describe("readings from all round", () => {
  test("give offset and soft iron of a bent sensor within the noise", () => {
    const fit = fitted(fitField(readings()));
    expect(fit.kind).toBe("ellipsoid");
    expect(farthest(fit.offset, OFFSET)).toBeLessThan(0.002);
    // The matrix undoes the sensor's distortion: together they only scale.
    const straight = [0, 1, 2].map((axis) =>
      times3(fit.matrix, [BENT[0][axis] ?? 0, BENT[1][axis] ?? 0, BENT[2][axis] ?? 0]),
    );
    for (const [row, vector] of straight.entries()) {
      for (const [column, value] of vector.entries()) {
        expect(value).toBeCloseTo(row === column ? fit.radius : 0, 2);
      }
    }
    expect(fit.residual).toBeGreaterThan(0.003);
    expect(fit.residual).toBeLessThan(0.007);
    expect(fit.rejected).toBeLessThan(10);
  });

  test("become a sphere round nothing when they are corrected", () => {
    const fit = fitted(fitField(readings()));
    const lengths = readings({ seed: 99 }).map((reading) => Math.hypot(...corrected(fit, reading)));
    expect(Math.max(...lengths.map((length) => Math.abs(length - fit.radius)))).toBeLessThan(0.03);
  });

  test.each([1, 2, 3, 4, 5])("are fitted whatever their noise and place are (%i)", (seed) => {
    const offset: Vector = [seed * 0.4 - 1, 1.5 - seed * 0.5, seed * 0.1];
    const fit = fitted(fitField(readings({ seed, offset, noise: 0.02, count: 900 })));
    expect(farthest(fit.offset, offset)).toBeLessThan(0.01);
    expect(fit.residual).toBeLessThan(0.03);
  });

  test("of a perfect sphere give that sphere", () => {
    const fit = fitted(fitField(readings({ shape: SPHERE, noise: 0 })));
    expect(farthest(fit.offset, OFFSET)).toBeLessThan(1e-9);
    expect(fit.radius).toBeCloseTo(1, 9);
    expect(fit.rejected).toBe(0);
  });

  test("are fitted as well in another unit", () => {
    const micro = readings().map(([x, y, z]): Vector => [45e-6 * x, 45e-6 * y, 45e-6 * z]);
    const fit = fitted(fitField(micro));
    expect(farthest(fit.offset, [45e-6 * OFFSET[0], 45e-6 * OFFSET[1], 45e-6 * OFFSET[2]])).toBeLessThan(
      1e-7,
    );
  });

  test("lose what a passing magnet did to some of them", () => {
    const random = numbers(3);
    const disturbed = readings().map(
      (reading, index): Vector =>
        index % 20 === 0 ? [reading[0] + 0.6 * random(), reading[1] - 0.5, reading[2] + 0.4] : reading,
    );
    const fit = fitted(fitField(disturbed));
    expect(fit.rejected).toBeGreaterThanOrEqual(25);
    expect(fit.rejected).toBeLessThan(45);
    expect(farthest(fit.offset, OFFSET)).toBeLessThan(0.003);
  });
});

describe("readings from some sides only", () => {
  test("give a sphere where an ellipsoid would be a guess", () => {
    const fit = fitted(fitField(readings({ shape: SPHERE, where: ([, , z]) => z > 0.05 })));
    expect(fit.kind).toBe("sphere");
    expect(farthest(fit.offset, OFFSET)).toBeLessThan(0.02);
  });

  test("give nothing where they are too few sides", () => {
    const answer = fitField(readings({ where: ([x]) => x > 0.75 }));
    expect(answer).toMatchObject({ kind: "refused", why: "notCovered" });
  });

  test("of a flat circle give nothing", () => {
    const flat = readings({ noise: 0 }).map(([x, y]): Vector => {
      const length = Math.hypot(x, y);
      return [x / length, y / length, 0.2];
    });
    expect(fitField(flat).kind).toBe("refused");
  });
});

test.each([
  ["none", []],
  ["too few", readings({ count: 20 })],
  ["the same one again and again", Array.from({ length: 200 }, (): Vector => [0.1, 0.2, 0.3])],
  ["all zero", Array.from({ length: 200 }, (): Vector => [0, 0, 0])],
  ["a straight line", Array.from({ length: 200 }, (_, index): Vector => [index, 2 * index, -index])],
  ["a plane", readings().map(([x, y]): Vector => [x, y, 0])],
  ["nothing finite", Array.from({ length: 200 }, (): Vector => [Number.NaN, 1, Number.POSITIVE_INFINITY])],
] as const)("%s give a refusal and no number that is none", (_, points) => {
  const answer = fitField(points);
  expect(answer.kind).toBe("refused");
  expect(Number.isFinite(answer.coverage)).toBe(true);
});

test("one reading that is none among good ones is left out", () => {
  const fit = fitted(fitField([...readings(), [Number.NaN, 0, 0]]));
  expect(farthest(fit.offset, OFFSET)).toBeLessThan(0.002);
});

describe("the solver", () => {
  test("finds what solves the rows best", () => {
    const rows = [
      [1, 0],
      [1, 1],
      [1, 2],
      [1, 3],
    ];
    const [start = 0, slope = 0] = leastSquares(rows, [1, 3, 5, 7.4]) ?? [];
    expect(start).toBeCloseTo(0.92, 9);
    expect(slope).toBeCloseTo(2.12, 9);
  });

  test("says when the rows do not decide it", () => {
    expect(leastSquares([[1, 2]], [1])).toBeNull();
    expect(
      leastSquares(
        [
          [1, 2],
          [2, 4],
          [3, 6],
        ],
        [1, 2, 3],
      ),
    ).toBeNull();
  });

  test("finds the axes of a symmetric matrix", () => {
    const { values, vectors } = eigen3([
      [2, 1, 0],
      [1, 2, 0],
      [0, 0, 5],
    ]);
    expect([...values].sort()).toEqual([1, 3, 5].map((value) => expect.closeTo(value, 9)));
    for (const [index, vector] of vectors.entries()) {
      expect(Math.hypot(...vector)).toBeCloseTo(1, 9);
      const turned = times3(
        [
          [2, 1, 0],
          [1, 2, 0],
          [0, 0, 5],
        ],
        vector,
      );
      expect(
        farthest(turned, vector.map((part) => part * (values[index] ?? 0)) as unknown as Vector),
      ).toBeLessThan(1e-9);
    }
  });
});

describe("the hint", () => {
  test("names the side that was never shown", () => {
    const seen = (unseen: (direction: Vector) => boolean): number[] =>
      DIRECTIONS.map((direction) => (unseen(direction) ? 0 : 3));
    expect(missingSide(seen(([, , z]) => z < -0.3))).toBe("top");
    expect(missingSide(seen(([, y]) => y > 0.4))).toBe("right");
    expect(missingSide(seen(([x]) => x < -0.4))).toBe("tail");
    expect(missingSide(seen(() => false))).toBeNull();
  });
});
