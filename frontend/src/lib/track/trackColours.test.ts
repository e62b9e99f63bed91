import { describe, expect, test } from "vitest";
import { colourOf, rangeOf, rgb, SCALES, UNKNOWN_COLOUR } from "./trackColours";
import type { TrackPoints, ValueRange } from "./trackPoints";

function track(altitude_m: ValueRange | null, climb_mps: ValueRange | null = null): TrackPoints {
  return { altitude_m, climb_mps, speed_mps: null } as TrackPoints;
}

const same = (si: number): number => si;

describe("the colour of a value", () => {
  const range = { least: 0, most: 60 };

  test("is the scale's own at each of its steps", () => {
    SCALES.height.forEach((colour, step) => {
      expect(colourOf(SCALES.height, range, 10 * step)).toBe(colour);
    });
  });

  test("lies half way between two steps in each of red, green and blue", () => {
    expect(colourOf(["#000000", "#ff8040"], range, 30)).toBe("#804020");
    expect(colourOf(["#ff8040", "#000000"], range, 45)).toBe("#402010");
  });

  test("beyond the range is that of its end", () => {
    expect(colourOf(SCALES.climb, range, -5)).toBe(SCALES.climb[0]);
    expect(colourOf(SCALES.climb, range, 61)).toBe(SCALES.climb.at(-1));
  });

  test("that is not known is grey, and no colour of a scale", () => {
    expect(colourOf(SCALES.speed, range, null)).toBe(UNKNOWN_COLOUR);
    expect(colourOf(SCALES.speed, range, Number.NaN)).toBe(UNKNOWN_COLOUR);
    expect(Object.values(SCALES).flat()).not.toContain(UNKNOWN_COLOUR);
  });
});

test("both scales can be read by lightness: it grows all along one and falls to both sides of the other's middle", () => {
  const lightness = (colour: string): number => {
    const [red, green, blue] = rgb(colour);
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue;
  };
  const height = SCALES.height.map(lightness);
  expect(height).toEqual([...height].sort((one, other) => one - other));
  const climb = SCALES.climb.map(lightness);
  expect(Math.max(...climb)).toBe(climb[3]);
});

describe("the range of a scale", () => {
  test("begins at zero and ends with a round number that no track exceeds", () => {
    expect(rangeOf("height", [track({ least: 20, most: 310 })], same)).toEqual({ least: 0, most: 400 });
    const both = [track({ least: 20, most: 310 }), track({ least: 5, most: 612 })];
    expect(rangeOf("height", both, same)).toEqual({ least: 0, most: 800 });
  });

  test("is round in the unit that is shown", () => {
    expect(rangeOf("height", [track({ least: 0, most: 100 })], (m) => m / 0.3048)).toEqual({
      least: 0,
      most: 400,
    });
  });

  test("begins below zero where the track does", () => {
    expect(rangeOf("height", [track({ least: -13, most: 50 })], same)).toEqual({ least: -20, most: 50 });
  });

  test("of a climb has level flight in its middle, however the track lies", () => {
    const sinking = track(null, { least: -4.4, most: 1 });
    expect(rangeOf("climb", [sinking], same)).toEqual({ least: -5, most: 5 });
    expect(rangeOf("climb", [track(null, { least: -1, most: 2.5 })], same)).toEqual({ least: -3, most: 3 });
  });

  test("goes on to the next decade after its last round number", () => {
    expect(rangeOf("height", [track({ least: 0, most: 900 })], same)).toEqual({ least: 0, most: 1000 });
  });

  test("never has its ends in one place", () => {
    expect(rangeOf("height", [track({ least: 0, most: 0 })], same)).toEqual({ least: 0, most: 1 });
  });

  test("is unknown while no track has such a value", () => {
    expect(rangeOf("speed", [track({ least: 0, most: 9 })], same)).toBeNull();
    expect(rangeOf("height", [], same)).toBeNull();
  });
});
