import { expect, test } from "vitest";
import { crossingSides } from "./fenceBorder";

const places = (corners: ReadonlyArray<readonly [number, number]>) =>
  corners.map(([latitude_deg, longitude_deg]) => ({ latitude_deg, longitude_deg }));

// The same borders as in the gateway's test.
test.each([
  {
    what: "a bow tie",
    corners: [
      [27, -15],
      [28, -14],
      [28, -15],
      [27, -14],
    ],
    sides: [0, 2],
  },
  {
    what: "one over the date line",
    corners: [
      [0, 179.5],
      [1, -179.5],
      [1, 179.5],
      [0, -179.5],
    ],
    sides: [0, 2],
  },
  {
    what: "a corner on a side",
    corners: [
      [0, 0],
      [0, 2],
      [2, 1],
      [0, 1],
      [2, 0],
    ],
    sides: [0, 2],
  },
  {
    what: "a spike",
    corners: [
      [0, 0],
      [0, 2],
      [0, 1],
      [1, 1],
    ],
    sides: [0, 1],
  },
  {
    what: "a triangle",
    corners: [
      [28, -15.5],
      [28, -15.4],
      [28.1, -15.4],
    ],
    sides: null,
  },
  {
    what: "a notch",
    corners: [
      [0, 0],
      [0, 3],
      [2, 3],
      [2, 2],
      [1, 2],
      [1, 1],
      [2, 1],
      [2, 0],
    ],
    sides: null,
  },
  {
    what: "two corners",
    corners: [
      [0, 0],
      [0, 1],
    ],
    sides: null,
  },
] as const)("$what: the sides that cross", ({ corners, sides }) => {
  expect(crossingSides(places(corners))).toEqual(sides);
});
