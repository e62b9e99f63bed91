import { expect, test } from "vitest";
import { AIRSPEED_GEOMETRY } from "./geometry";

const { pointerAngle_deg, numerals, reach } = AIRSPEED_GEOMETRY.kt;

test("zero is at the top and speed turns the pointer clockwise", () => {
  expect(pointerAngle_deg(0)).toBe(0);
  expect(pointerAngle_deg(80)).toBe(165);
  expect(pointerAngle_deg(80)).toBeLessThan(pointerAngle_deg(81));
});

test("the end is a stop short of the top: 161 knots cannot be read as 1", () => {
  expect(pointerAngle_deg(161)).toBe(330);
  expect(pointerAngle_deg(1000)).toBe(330);
  expect(reach(160)).toBe("within");
  expect(reach(161)).toBe("above");
});

test("a speed below zero, which a pitot can report at rest, rests at zero and says so", () => {
  expect(pointerAngle_deg(-3)).toBe(0);
  expect(reach(-3)).toBe("below");
});

test("the noise of a tube at rest is no speed beyond the scale", () => {
  expect(reach(-1.5)).toBe("within");
  expect(pointerAngle_deg(-1.5)).toBe(0);
});

test("each numeral stands where the pointer points at its speed", () => {
  expect(numerals.map(({ text }) => text)).toEqual(["0", "20", "40", "60", "80", "100", "120", "140", "160"]);
  for (const { text, x, y } of numerals) {
    const pointed_deg = (Math.atan2(x, -y) * 180) / Math.PI;
    expect((pointed_deg + 360) % 360).toBeCloseTo(pointerAngle_deg(Number(text)), 0);
  }
});

test.each([
  ["kmPerH", 100, 54],
  ["mPerS", 30, 58.315],
] as const)("a face in %s points at %d for a speed of %d knots", (unit, engraved, airspeed_kt) => {
  const other = AIRSPEED_GEOMETRY[unit];
  const numeral = other.numerals.find(({ text }) => text === String(engraved));
  const pointed_deg = (Math.atan2(numeral?.x ?? 0, -(numeral?.y ?? 0)) * 180) / Math.PI;
  expect((pointed_deg + 360) % 360).toBeCloseTo(other.pointerAngle_deg(airspeed_kt), 0);
});
