import { expect, test } from "vitest";
import { angleText, graticuleStep_s, linesBetween_s } from "./graticule";

test("the lines stand closer on each deeper level, in steps that people count in", () => {
  const steps = Array.from({ length: 18 }, (_, level) => graticuleStep_s(level));
  expect(steps).toEqual([...steps].sort((one, other) => other - one));
  expect(graticuleStep_s(3)).toBe(54_000);
  expect(graticuleStep_s(10)).toBe(600);
  expect(graticuleStep_s(17)).toBe(5);
});

test.each(Array.from({ length: 17 }, (_, level) => level + 1))("no tile of level %i is crowded", (level) => {
  const lines = 180 / 2 ** level / (graticuleStep_s(level) / 3600);
  expect(lines).toBeLessThanOrEqual(1.6);
  expect(lines).toBeGreaterThan(0.5);
});

test("lines are whole multiples of the step, both ends included", () => {
  expect(linesBetween_s(-15.5, -15, 600)).toEqual([-55_800, -55_200, -54_600, -54_000]);
  expect(linesBetween_s(0.01, 0.02, 600)).toEqual([]);
});

test("an angle is told in degrees, minutes and seconds, as far as the step needs them", () => {
  expect(angleText(28 * 3600, 3600, "N", "S")).toBe("28°N");
  expect(angleText(27 * 3600 + 55 * 60, 300, "N", "S")).toBe("27°55′N");
  expect(angleText(-(15 * 3600 + 5 * 60 + 3), 1, "E", "O")).toBe("15°05′03″O");
  expect(angleText(0, 3600, "N", "S")).toBe("0°");
});
