import { describe, expect, test } from "vitest";
import { EDGES, edgeAt, floatingAt, movedBy, placeText, readPlace } from "./places";

const window = { width: 1000, height: 600 };
const bar = { width: 200, height: 50 };

describe("a remembered place", () => {
  test("is read as it was written", () => {
    for (const edge of EDGES) {
      expect(readPlace(placeText({ edge }))).toEqual({ edge });
    }
    expect(readPlace(placeText({ x: 0.25, y: 1 }))).toEqual({ x: 0.25, y: 1 });
  });

  test.each([undefined, "", "middle", "0.5", "NaN NaN", "-1 0", "1e9 1e9"])(
    "that is none (%s) is the top",
    (text) => {
      expect(readPlace(text)).toEqual({ edge: "top" });
    },
  );

  test("beyond the window is brought back into it", () => {
    expect(readPlace("1.9000 0.5000")).toEqual({ x: 1, y: 0.5 });
  });
});

describe("a dragged toolbar", () => {
  test.each([
    ["top", { x: 500, y: 10 }],
    ["bottom", { x: 500, y: 590 }],
    ["left", { x: 5, y: 300 }],
    ["right", { x: 998, y: 300 }],
  ] as const)("is docked at the %s edge when it is let go there", (edge, point) => {
    expect(edgeAt(point, window)).toBe(edge);
  });

  test("floats in the middle, and takes the nearer edge of a corner", () => {
    expect(edgeAt({ x: 500, y: 300 }, window)).toBeNull();
    expect(edgeAt({ x: 20, y: 10 }, window)).toBe("top");
  });

  test("keeps its share of the room, and never leaves the window", () => {
    expect(floatingAt({ x: 400, y: 275 }, bar, window)).toEqual({ x: 0.5, y: 0.5 });
    expect(floatingAt({ x: -50, y: 5000 }, bar, window)).toEqual({ x: 0, y: 1 });
    expect(floatingAt({ x: 10, y: 10 }, { width: 2000, height: 50 }, window)).toMatchObject({ x: 0 });
  });
});

describe("an arrow key", () => {
  test("takes a docked toolbar to its edge", () => {
    expect(movedBy("ArrowDown", { edge: "top" })).toEqual({ edge: "bottom" });
    expect(movedBy("ArrowLeft", { edge: "top" })).toEqual({ edge: "left" });
    expect(movedBy("ArrowUp", { edge: "top" })).toBeNull();
  });

  test("moves a floating one a step, up to the window's end", () => {
    expect(movedBy("ArrowRight", { x: 0.5, y: 0.5 })).toEqual({ x: 0.52, y: 0.5 });
    expect(movedBy("ArrowUp", { x: 0.5, y: 0 })).toEqual({ x: 0.5, y: 0 });
  });

  test("only", () => {
    expect(movedBy("a", { edge: "top" })).toBeNull();
    expect(movedBy("Enter", { x: 0, y: 0 })).toBeNull();
  });
});
