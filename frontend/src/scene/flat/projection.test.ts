import { expect, test } from "vitest";
import { distance_m } from "../../lib/geodesy";
import { around, type FlatView, fromScreen, metresPerPixel, panned, toScreen, zoomed } from "./projection";

const GANDO = { latitude_deg: 27.93, longitude_deg: -15.38 };
const VIEW: FlatView = { centre: GANDO, zoom: 12, width_px: 800, height_px: 600 };

test("each pixel is a place, and the place that pixel", () => {
  for (const at of [
    { x: 0, y: 0 },
    { x: 400, y: 300 },
    { x: 799, y: 12 },
  ]) {
    const back = toScreen(VIEW, fromScreen(VIEW, at));
    expect(back.x).toBeCloseTo(at.x, 6);
    expect(back.y).toBeCloseTo(at.y, 6);
  }
  expect(toScreen(VIEW, GANDO)).toEqual({ x: 400, y: 300 });
});

test("north is up and east is right", () => {
  const { x, y } = toScreen(VIEW, { latitude_deg: 27.94, longitude_deg: -15.37 });
  expect(x).toBeGreaterThan(400);
  expect(y).toBeLessThan(300);
});

test("the scale is that of the ground", () => {
  const [from, to] = [fromScreen(VIEW, { x: 350, y: 300 }), fromScreen(VIEW, { x: 450, y: 300 })];
  expect(distance_m(from, to) / 100).toBeCloseTo(metresPerPixel(VIEW), 2);
});

test("zooming holds what lies under the pointer, and ends at its bounds", () => {
  const at = { x: 100, y: 500 };
  const held = fromScreen(VIEW, at);
  const nearer = toScreen(zoomed(VIEW, 2, at), held);
  expect(nearer.x).toBeCloseTo(100, 6);
  expect(nearer.y).toBeCloseTo(500, 6);
  expect(zoomed(VIEW, 100, at).zoom).toBe(20);
  expect(zoomed(VIEW, -100, at).zoom).toBe(3);
});

test("panning to and fro comes back", () => {
  const { latitude_deg, longitude_deg } = panned(panned(VIEW, 200, -90), -200, 90).centre;
  expect(latitude_deg).toBeCloseTo(GANDO.latitude_deg, 9);
  expect(longitude_deg).toBeCloseTo(GANDO.longitude_deg, 9);
});

test("all places that are asked for are seen, and one alone is in the middle", () => {
  const places = [
    GANDO,
    { latitude_deg: 28.15, longitude_deg: -15.7 },
    { latitude_deg: 27.75, longitude_deg: -15.6 },
  ];
  const view = around(VIEW, places);
  for (const place of places) {
    const { x, y } = toScreen(view, place);
    expect([x > 0, x < 800, y > 0, y < 600]).toEqual([true, true, true, true]);
  }
  expect(around(VIEW, [GANDO]).centre.latitude_deg).toBeCloseTo(27.93, 6);
  expect(around(VIEW, [])).toBe(VIEW);
});
