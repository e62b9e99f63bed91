import { expect, test } from "vitest";
import { coveredBy, lowestLevel } from "./imagery";

const CANARIES = { west_deg: -18.5, south_deg: 27.5, east_deg: -13.3, north_deg: 29.5 };
const WORLD = { west_deg: -180, south_deg: -90, east_deg: 180, north_deg: 90 };

test("a map of some islands is seen from afar too, by its own lowest level", () => {
  expect(lowestLevel({ ...CANARIES, url: "", minimum_zoom: 8, maximum_zoom: 15 })).toBe(8);
});

test("a file of small tiles that claims the whole Earth is not laid on it all at once", () => {
  expect(lowestLevel({ ...WORLD, url: "", minimum_zoom: 10, maximum_zoom: 15 })).toBe(0);
  expect(lowestLevel({ ...WORLD, url: "", minimum_zoom: 3, maximum_zoom: 15 })).toBe(3);
});

test("what a source covers ends with the map, and is all of it where the source says nothing that can be", () => {
  const all = { west_deg: -180, south_deg: -85.0511, east_deg: 180, north_deg: 85.0511 };
  expect(coveredBy(CANARIES)).toEqual(CANARIES);
  expect(coveredBy(WORLD)).toEqual(all);
  expect(coveredBy({ ...WORLD, south_deg: 86 })).toEqual(all);
  expect(coveredBy({ west_deg: 0, south_deg: 0, east_deg: 0, north_deg: 0 })).toEqual(all);
});
