import { readFileSync } from "node:fs";
import { join } from "node:path";
import { expect, test } from "vitest";
import { GRAN_CANARIA, runwayCourse } from "./airfields";
import { CHART, needsFade, readIslands } from "./coast";
import { clipFilled, overlaps, tileBox } from "./geometry";

test.each(GRAN_CANARIA.runways)(
  "runway $ends.0.name is 3100 m long and lies as its number says",
  (runway) => {
    const { length_m, bearing_deg } = runwayCourse(runway);
    expect(length_m).toBeGreaterThan(3050);
    expect(length_m).toBeLessThan(3150);
    // Runway 03 with five degrees of westerly variation.
    expect(bearing_deg).toBeGreaterThan(20);
    expect(bearing_deg).toBeLessThan(29);
  },
);

const islands = readIslands(
  readFileSync(join(import.meta.dirname, "../../../../public/map/canary-coastline.json"), "utf8"),
);

test("the coastline holds all the islands, closed by themselves, inside the chart", () => {
  expect(islands.length).toBe(40);
  expect(islands.every(({ ring }) => ring.length >= 6 && ring[0] !== ring.at(-1))).toBe(true);
  expect(islands.every(({ box }) => overlaps(box, CHART))).toBe(true);
});

test("the runways lie on land", () => {
  for (const { ends } of GRAN_CANARIA.runways) {
    for (const { latitude_deg, longitude_deg } of ends) {
      const spot = {
        west_deg: longitude_deg - 1e-4,
        east_deg: longitude_deg + 1e-4,
        south_deg: latitude_deg - 1e-4,
        north_deg: latitude_deg + 1e-4,
      };
      expect(islands.some(({ ring }) => clipFilled(ring, spot).length > 2)).toBe(true);
    }
  }
});

test("only tiles at the chart's border are made soft", () => {
  expect(needsFade({ west_deg: -15.5, south_deg: 27.9, east_deg: -15.4, north_deg: 28 })).toBe(false);
  expect(needsFade({ west_deg: -19, south_deg: 27.9, east_deg: -18.5, north_deg: 28 })).toBe(true);
  expect(needsFade(tileBox(3, 7, 2))).toBe(true);
});
