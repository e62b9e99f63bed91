import { describe, expect, test } from "vitest";
import { destination, distance_m, type Position } from "../../lib/geodesy";
import { type Projection, project, projectionAround, scaleBar } from "./geometry";

const picture = { width: 400, height: 300, rim: 20 };
const gando: Position = { latitude_deg: 27.9319, longitude_deg: -15.3866 };

function fitted(places: readonly Position[]): Projection {
  const projection = projectionAround(places, picture);
  if (projection === null) {
    throw new Error("nothing to fit");
  }
  return projection;
}

test("without places there is no picture", () => {
  expect(projectionAround([], picture)).toBeNull();
});

describe("places", () => {
  const places = [gando, destination(gando, 0, 4000), destination(gando, 90, 9000)];

  test("all lie within the rim, north up and east right", () => {
    const projection = fitted(places);
    const [origin, north, east] = places.map((place) => project(projection, place));
    for (const point of [origin, north, east]) {
      expect(point?.x).toBeGreaterThanOrEqual(picture.rim - 0.5);
      expect(point?.x).toBeLessThanOrEqual(picture.width - picture.rim + 0.5);
      expect(point?.y).toBeGreaterThanOrEqual(picture.rim - 0.5);
      expect(point?.y).toBeLessThanOrEqual(picture.height - picture.rim + 0.5);
    }
    expect(north?.y).toBeLessThan(origin?.y ?? 0);
    expect(north?.x).toBeCloseTo(origin?.x ?? 0, 0);
    expect(east?.x).toBeGreaterThan(origin?.x ?? 0);
  });

  test("are true to scale within a thousandth over the length of an island", () => {
    const far = destination(gando, 45, 30_000);
    const projection = fitted([gando, far]);
    const [one, other] = [project(projection, gando), project(projection, far)];
    const drawn_m = Math.hypot(other.x - one.x, other.y - one.y) / projection.units_per_m;
    expect(Math.abs(drawn_m / distance_m(gando, far) - 1)).toBeLessThan(0.001);
  });

  test("on both sides of the date line lie together", () => {
    const west = { latitude_deg: 0, longitude_deg: 179.99 };
    const east = { latitude_deg: 0, longitude_deg: -179.99 };
    const projection = fitted([west, east]);
    expect(project(projection, west).x).toBeCloseTo(picture.rim, 0);
    expect(project(projection, east).x).toBeCloseTo(picture.width - picture.rim, 0);
  });
});

test("a single place stands in the middle", () => {
  expect(project(fitted([gando]), gando)).toEqual({ x: 200, y: 150 });
});

test.each([1000, 7000, 40_000, 3_000_000])("the scale bar over %d m is a round length that fits", (span) => {
  const projection = fitted([gando, destination(gando, 90, span)]);
  const { length_m, units } = scaleBar(projection);
  expect(String(length_m)).toMatch(/^[125]0*$/);
  expect(units).toBeLessThanOrEqual(picture.width * 0.3);
  expect(units).toBeGreaterThan(picture.width * 0.1);
  expect(units / projection.units_per_m).toBeCloseTo(length_m, 6);
});
