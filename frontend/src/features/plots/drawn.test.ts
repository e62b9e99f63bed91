import { describe, expect, test } from "vitest";
import { cut, drawnOf, valueAt } from "./drawn";

function drawn(at_s: readonly number[], values: ReadonlyArray<number | null>, high = values) {
  return drawnOf({
    name: "ahrs.roll_deg",
    unit: "deg",
    at_s: [...at_s],
    min: [...values],
    max: [...high],
    mean: 1,
    count: values.length,
  });
}

describe("the value at a moment", () => {
  const signal = drawn([0, 1, 2, 3], [10, 11, null, 13], [10, 12, null, 13]);

  test.each([
    { moment_s: -0.4, found: [10, 10] },
    { moment_s: 0.4, found: [10, 10] },
    { moment_s: 0.6, found: [11, 12] },
    { moment_s: 1, found: [11, 12] },
    { moment_s: 2, found: null },
    { moment_s: 3.4, found: [13, 13] },
    { moment_s: 60, found: null },
    { moment_s: -60, found: null },
  ])("$moment_s s is that of the nearest step, and none in a gap or far from all", ({ moment_s, found }) => {
    expect(valueAt(signal, moment_s)).toEqual(found);
  });

  test("nothing has no value", () => {
    expect(valueAt(drawn([], []), 1)).toBeNull();
  });
});

test("a spike of one sample is in what is drawn of every stretch that holds it", () => {
  const at_s = Array.from({ length: 2000 }, (_, index) => index * 3.6);
  const values = at_s.map((_, index) => (index === 777 ? 50 : 0));
  const signal = drawn(
    at_s,
    values.map(() => 0),
    values,
  );
  for (const half_s of [3600, 400, 40, 4, 0.5]) {
    expect(Math.max(...cut(signal, 2797.2 - half_s, 2797.2 + half_s).high.map(Number))).toBe(50);
  }
});

test("two samples of one moment hide neither", () => {
  expect(valueAt(drawn([0, 0], [5, -5]), 0)).toEqual([-5, 5]);
});
