import { describe, expect, test } from "vitest";
import { fillTransform, markerTransform, servoBar } from "./geometry";

describe("a surface", () => {
  test("has its zero in the middle and plus at the positive end", () => {
    expect(servoBar("surface", -1).place).toBe(0);
    expect(servoBar("surface", 0).place).toBe(0.5);
    expect(servoBar("surface", 1).place).toBe(1);
  });

  test("stands upright with plus up: the mark rises with the value", () => {
    // CSS moves down for a positive share; the mark begins at the lower end.
    expect(markerTransform("vertical", servoBar("surface", -1).place)).toBe("translateY(0.00%)");
    expect(markerTransform("vertical", servoBar("surface", 1).place)).toBe("translateY(-100.00%)");
    expect(markerTransform("horizontal", servoBar("surface", 1).place)).toBe("translateX(100.00%)");
  });

  test("is filled from its middle to the mark, on either side", () => {
    expect(fillTransform("surface", "vertical", 0.75)).toBe("translateY(-50.00%) scaleY(0.2500)");
    expect(fillTransform("surface", "vertical", 0.25)).toBe("translateY(-25.00%) scaleY(0.2500)");
    expect(fillTransform("surface", "horizontal", 0.5)).toBe("translateX(50.00%) scaleX(0.0000)");
  });
});

test("a throttle is filled from its closed end", () => {
  expect(servoBar("throttle", 0.62).place).toBe(0.62);
  expect(fillTransform("throttle", "vertical", 0.62)).toBe("translateY(0.00%) scaleY(0.6200)");
});

test("beyond its ends a bar stops there and says so", () => {
  expect(servoBar("surface", 1.4)).toEqual({ place: 1, limited: true });
  expect(servoBar("surface", -1.01)).toEqual({ place: 0, limited: true });
  expect(servoBar("throttle", -0.2)).toEqual({ place: 0, limited: true });
  expect(servoBar("surface", 1)).toEqual({ place: 1, limited: false });
});
