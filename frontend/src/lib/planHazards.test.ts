import { describe, expect, test } from "vitest";
import type { Waypoint } from "./plan";
import { fenceHazards, groundHazards } from "./planHazards";
import { clearanceOf, profilePlaces } from "./planProfile";

const at = (latitude_deg: number, longitude_deg: number, altitude_ft = 1000): Waypoint => ({
  latitude_deg,
  longitude_deg,
  altitude_ft,
  speed_kt: 55,
});
/** A border with a notch from the north, over the date line. */
const CORNERS = [
  at(0, 179),
  at(0, -179),
  at(2, -179),
  at(2, -179.9),
  at(1, -179.9),
  at(1, 179.9),
  at(2, 179.9),
  at(2, 179),
];
const FENCE = { corners: CORNERS, ceiling_ft: null };
const said = (waypoints: readonly Waypoint[], fence = FENCE as Parameters<typeof fenceHazards>[1]) =>
  fenceHazards(waypoints, fence).map(({ code, row }) => `${row} ${code}`);

describe("the fence", () => {
  test("is kept by a plan inside it, and without a border or a ceiling there is none to leave", () => {
    expect(said([at(0.5, 179.5), at(0.5, -179.5)])).toEqual([]);
    expect(said([at(50, 0), at(50, 1)], { corners: [], ceiling_ft: null })).toEqual([]);
  });

  test("is left by waypoints outside, and by a leg over the notch between two waypoints inside", () => {
    expect(said([at(0.5, 179.5), at(3, 179.5)])).toEqual(["1 outside_fence"]);
    expect(said([at(1.5, 179.5), at(1.5, -179.5)])).toEqual(["1 leaves_fence"]);
  });

  test("has a ceiling, with a border or without", () => {
    const fence = { corners: [], ceiling_ft: 900 };
    expect(said([at(0.5, 179.5, 900), at(0.5, -179.5, 901)], fence)).toEqual(["1 above_ceiling"]);
  });
});

test("a leg whose ends are clear meets the ridge between them, and unknown ground is not taken for sea", () => {
  const waypoints = [at(28, -15.4), at(28, -15.3), at(28, -15.2)];
  const places = profilePlaces(waypoints, 500, 400);
  const ridge = places.map(({ longitude_deg, row }) =>
    row === 2 ? null : Math.abs(longitude_deg + 15.35) < 0.01 ? 400 : 0,
  );
  const found = groundHazards(clearanceOf(places, ridge, 300));
  expect(found.map(({ code, row }) => [code, row])).toEqual([["meets_ground", 1]]);
  expect(found[0]?.params["below_ft"]).toBeCloseTo(400 / 0.3048 - 1000, 0);
  expect(groundHazards(null)).toEqual([]);
});
