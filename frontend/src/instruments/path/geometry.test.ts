import { describe, expect, test } from "vitest";
import {
  bladeEnd,
  direction_deg,
  LOWER_Y,
  PATH_SWITCH,
  SOURCE_SWITCH,
  type Switches,
  signalWay,
  UPPER_Y,
} from "./geometry";

/** Names of the parts that are lit. */
function lit(switches: Switches): string[] {
  return Object.entries(signalWay(switches))
    .filter(([, live]) => live)
    .map(([part]) => part)
    .sort();
}

describe("the signal's way", () => {
  test("manual goes from the chosen source straight to the surfaces", () => {
    expect(lit({ source: "joystick", path: "manual", autopilot: false })).toEqual([
      "between",
      "joystick",
      "manual",
    ]);
    expect(lit({ source: "rc", path: "manual", autopilot: false })).toEqual(["between", "manual", "rc"]);
  });

  test("manual passes the board by, whatever its autopilot does", () => {
    expect(lit({ source: "rc", path: "manual", autopilot: true })).toEqual(["between", "manual", "rc"]);
    expect(lit({ source: "rc", path: "manual", autopilot: null })).toEqual(["between", "manual", "rc"]);
  });

  test("assisted goes through the computer", () => {
    expect(lit({ source: "joystick", path: "assisted", autopilot: false })).toEqual([
      "assisted",
      "between",
      "computer",
      "joystick",
    ]);
  });

  test("in automatic flight neither stick nor transmitter is on it", () => {
    expect(lit({ source: "joystick", path: "assisted", autopilot: true })).toEqual(["automatic", "computer"]);
    expect(lit({ source: "rc", path: "assisted", autopilot: true })).toEqual(["automatic", "computer"]);
  });

  test("what is not known is not lit", () => {
    expect(lit({ source: null, path: null, autopilot: null })).toEqual([]);
    expect(lit({ source: "rc", path: null, autopilot: false })).toEqual([]);
    expect(lit({ source: null, path: "manual", autopilot: false })).toEqual(["manual"]);
    expect(lit({ source: "rc", path: "assisted", autopilot: null })).toEqual(["computer"]);
  });
});

test("a blade lies on the contact of its position, and on none where that is not known", () => {
  expect(bladeEnd(SOURCE_SWITCH, "upper")).toEqual({ x: SOURCE_SWITCH.contactX, y: UPPER_Y });
  expect(bladeEnd(PATH_SWITCH, "lower")).toEqual({ x: PATH_SWITCH.contactX, y: LOWER_Y });
  const { y } = bladeEnd(PATH_SWITCH, null);
  expect(y).toBeGreaterThan(UPPER_Y);
  expect(y).toBeLessThan(LOWER_Y);
});

test("arrows point where their wire goes", () => {
  expect(direction_deg({ x: 0, y: 0 }, { x: 5, y: 0 })).toBe(0);
  expect(direction_deg({ x: 0, y: 9 }, { x: 0, y: 0 })).toBe(-90);
});
