import { describe, expect, test } from "vitest";
import { formatFlightTime } from "../../lib/moment";
import { atOf, LEAST_SPAN_S, panned, showing, ticks, wholeFlight, xOf, zoomed } from "./barGeometry";

describe("the view", () => {
  test("of a flight that has just begun is longer than the flight", () => {
    expect(wholeFlight(3)).toEqual({ from_s: 0, to_s: 30 });
    expect(wholeFlight(600)).toEqual({ from_s: 0, to_s: 600 });
  });

  test("places a moment at a pixel and finds it there again", () => {
    const view = { from_s: 100, to_s: 200 };
    expect(xOf(150, view, 800)).toBe(400);
    expect(atOf(400, view, 800)).toBe(150);
  });

  test("keeps the moment under the pointer while it zooms", () => {
    const before = wholeFlight(600);
    const after = zoomed(before, 200, 0.5, 600);
    expect(after.to_s - after.from_s).toBeCloseTo(300);
    expect(xOf(200, after, 900)).toBeCloseTo(xOf(200, before, 900));
  });

  test("never leaves the flight and never gets shorter than two seconds", () => {
    expect(zoomed(wholeFlight(600), 0, 5, 600)).toEqual(wholeFlight(600));
    const close = zoomed(wholeFlight(600), 600, 1e-6, 600);
    expect(close.to_s - close.from_s).toBeCloseTo(LEAST_SPAN_S);
    expect(close.to_s).toBe(600);
    expect(panned({ from_s: 500, to_s: 550 }, 200, 600)).toEqual({ from_s: 550, to_s: 600 });
  });

  test("follows a moment that leaves it, and stays where it is otherwise", () => {
    const view = { from_s: 100, to_s: 200 };
    expect(showing(view, 150, 600)).toBe(view);
    expect(showing(view, 250, 600)).toEqual({ from_s: 160, to_s: 260 });
    expect(showing(view, 50, 600)).toEqual({ from_s: 40, to_s: 140 });
  });
});

test("the ticks are round and far enough apart to be read", () => {
  const found = ticks({ from_s: 10, to_s: 610 }, 800, 80);
  expect(found[0]).toBe(60);
  expect(found[1]).toBe(120);
  expect(found.length).toBeLessThanOrEqual(10);
});

test("a time of a flight has hours only where it needs them, and rounds upwards as a clock does", () => {
  expect(formatFlightTime(9)).toBe("0:09");
  expect(formatFlightTime(3723)).toBe("1:02:03");
  expect(formatFlightTime(59.96, 1)).toBe("1:00.0");
});
