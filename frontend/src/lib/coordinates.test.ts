import { describe, expect, test } from "vitest";
import { formatPlace, NOTATIONS, parsePlace, placeOfUtm, utmOf } from "./coordinates";

function random(seed: number): () => number {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1_664_525) + 1_013_904_223) >>> 0;
    return state / 2 ** 32;
  };
}

const next = random(11);
const PLACES = Array.from({ length: 400 }, () => ({
  latitude_deg: next() * 163 - 79.5,
  longitude_deg: next() * 360 - 180,
}));

describe("UTM", () => {
  // By PROJ, from WGS 84.
  test.each([
    [27.9319, -15.3866, 28, 461_964.48, 3_089_718.73],
    [0, -177, 1, 500_000, 0],
    [60, 5, 32, 276_979.93, 6_658_157.2],
    [-33.9, 151.2, 56, 333_568.94, 6_247_473.34],
    [78, 20, 33, 615_914.52, 8_663_320.2],
  ])("of %d, %d is in zone %d at %d, %d", (latitude_deg, longitude_deg, zone, easting_m, northing_m) => {
    const found = utmOf({ latitude_deg, longitude_deg });
    expect(found?.zone).toBe(zone);
    expect(Math.abs((found?.easting_m ?? 0) - easting_m)).toBeLessThan(0.05);
    expect(Math.abs((found?.northing_m ?? 0) - northing_m)).toBeLessThan(0.05);
  });

  test("comes back to its place within a millimetre, anywhere", () => {
    for (const place of PLACES) {
      const utm = utmOf(place);
      const back = utm === null ? place : placeOfUtm(utm);
      expect(Math.abs(back.latitude_deg - place.latitude_deg)).toBeLessThan(1e-8);
      const turn_deg = Math.abs(back.longitude_deg - place.longitude_deg) % 360;
      expect(Math.min(turn_deg, 360 - turn_deg)).toBeLessThan(1e-7);
    }
    expect(utmOf({ latitude_deg: 85, longitude_deg: 0 })).toBeNull();
  });
});

describe("a place that is typed", () => {
  test.each(NOTATIONS)("as it is shown in %s is the place again, within half a metre", (notation) => {
    for (const place of PLACES) {
      const back = parsePlace(formatPlace(place, notation));
      expect(Math.abs((back?.latitude_deg ?? Number.NaN) - place.latitude_deg)).toBeLessThan(4e-6);
      const turn_deg = Math.abs((back?.longitude_deg ?? Number.NaN) - place.longitude_deg) % 360;
      const narrow = Math.cos((place.latitude_deg * Math.PI) / 180);
      expect(Math.min(turn_deg, 360 - turn_deg) * narrow).toBeLessThan(4e-6);
    }
  });

  test.each([
    "27.9319 -15.3866",
    "27.9319, -15.3866",
    "27.9319,-15.3866",
    "27,9319; -15,3866",
    "27.9319N 15.3866W",
    "N27.9319 W15.3866",
    "15.3866 O, 27.9319 N",
    "27° 55.914' N 15° 23.196' O",
    "27°55'54.84\"N 15°23'11.76\"W",
    "27 55 54.84 -15 23 11.76",
    "n 27 55 54.84, w 15 23 11.76",
  ])("as %s is Gando", (text) => {
    const place = parsePlace(text);
    expect(place?.latitude_deg).toBeCloseTo(27.9319, 5);
    expect(place?.longitude_deg).toBeCloseTo(-15.3866, 5);
  });

  test.each([
    "",
    "Gando",
    "27.9",
    "91 0",
    "0 181",
    "27 60 0 N 15 0 0 W",
    "27.9 N 15.4 N",
    "-27.9 N 15 W",
    "61R 461990 3089732",
    "28R 46 3089732",
  ])("as %j is none", (text) => {
    expect(parsePlace(text)).toBeNull();
  });
});
