import { expect, test } from "vitest";
import { digitsPath } from "./digits";

/** All points of a path. */
function points(path: string): { x: number; y: number }[] {
  return [...path.matchAll(/(?<x>-?[\d.]+) (?<y>-?[\d.]+)/g)].map(({ groups }) => ({
    x: Number(groups?.["x"]),
    y: Number(groups?.["y"]),
  }));
}

test("every digit has a shape of its own, as high as asked for and centred where asked for", () => {
  const shapes = Array.from({ length: 10 }, (_, digit) => digitsPath(digit, 50, -20, 6));
  expect(new Set(shapes).size).toBe(10);
  for (const shape of shapes) {
    const heights = points(shape).map(({ y }) => y);
    expect(Math.min(...heights)).toBe(-23);
    expect(Math.max(...heights)).toBe(-17);
    expect(points(shape).every(({ x }) => x >= 48 && x <= 52)).toBe(true);
  }
});

test("digits of a number stand beside each other in order, centred together", () => {
  const both = digitsPath(48, 0, 0, 6);
  expect(both.startsWith(digitsPath(4, -2.9, 0, 6))).toBe(true);
  expect(both.endsWith(digitsPath(8, 2.9, 0, 6))).toBe(true);
});

test("twice the height is twice the width", () => {
  const widths = [6, 12].map((height) => Math.max(...points(digitsPath(90, 0, 0, height)).map(({ x }) => x)));
  expect(widths[1]).toBe((widths[0] ?? 0) * 2);
});
