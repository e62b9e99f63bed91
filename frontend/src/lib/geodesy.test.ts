import { describe, expect, test } from "vitest";
import { bearing_deg, destination, distance_m, type Position } from "./geodesy";

const at = (latitude_deg: number, longitude_deg: number): Position => ({ latitude_deg, longitude_deg });
const gando = at(27.9319, -15.3866);
const madrid = at(40.4168, -3.7038);
const newYork = at(40.7128, -74.006);

describe("a distance", () => {
  test.each([
    ["one degree of a meridian", gando, at(28.9319, -15.3866), 111195.08],
    ["one degree along the equator, across the date line", at(0, 179.5), at(0, -179.5), 111195.08],
    ["from pole to pole", at(90, 0), at(-90, 0), 20015114.4],
    ["from Madrid to New York", madrid, newYork, 5768012.2],
    ["the first leg of the Gando route", at(27.9515, -15.3741), at(27.9503, -15.3573), 1655.6],
  ])("of %s is that of the sphere", (_, from, to, metres) => {
    expect(distance_m(from, to)).toBeCloseTo(metres, 0);
    expect(distance_m(to, from)).toBeCloseTo(metres, 0);
  });

  test("keeps its precision where the points nearly coincide", () => {
    expect(distance_m(gando, at(27.9319 + 1e-6, -15.3866))).toBeCloseTo(0.1112, 4);
    expect(distance_m(gando, gando)).toBe(0);
  });
});

describe("a bearing", () => {
  test.each([
    [gando, at(28, -15.3866), 0],
    [gando, at(27, -15.3866), 180],
    [at(0, 10), at(0, 11), 90],
    [at(0, 10), at(0, 9), 270],
    [at(0, 179.5), at(0, -179.5), 90],
    [madrid, newYork, 294.8803],
  ])("is clockwise from north", (from, to, degrees) => {
    expect(bearing_deg(from, to)).toBeCloseTo(degrees, 3);
  });

  test("to the same place is none", () => {
    expect(bearing_deg(gando, gando)).toBeNull();
  });
});

describe("a place at a distance", () => {
  test.each([0, 37.5, 90, 180, 271, 359])("lies there, seen from where it was taken (%d deg)", (bearing) => {
    const there = destination(gando, bearing, 12_345);
    expect(distance_m(gando, there)).toBeCloseTo(12_345, 3);
    expect(bearing_deg(gando, there)).toBeCloseTo(bearing, 6);
  });

  test("keeps its longitude in -180..180", () => {
    expect(destination(at(0, 179.9), 90, 50_000).longitude_deg).toBeCloseTo(-179.65, 2);
  });
});
