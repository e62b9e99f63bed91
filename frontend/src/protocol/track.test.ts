import { describe, expect, test } from "vitest";
import { trackBytes } from "../test/trackBytes";
import { readTrackPiece } from "./track";

const GANDO = { t_ms: 20, latitude_e7: 279_300_000, longitude_e7: -153_800_000, altitude_mm: 24_500 };

test("a piece says which points it holds, and each of them", () => {
  const bytes = trackBytes([GANDO, { ...GANDO, t_ms: 40, altitude_mm: -1_000 }], {
    epoch: 7,
    first: 100,
    total: 102,
    t0_s: 1_700_000_000.5,
  });
  const piece = readTrackPiece(bytes);
  expect(piece).toMatchObject({ epoch: 7, first: 100, count: 2, total: 102 });
  expect(piece?.at(0)).toEqual({
    t_s: 1_700_000_000.52,
    latitude_e7: 279_300_000,
    longitude_e7: -153_800_000,
    altitude_mm: 24_500,
  });
  expect(piece?.at(1)?.altitude_mm).toBe(-1_000);
});

describe("refused is", () => {
  const whole = trackBytes([GANDO, GANDO]);
  const changed = (at: number, value: number): ArrayBuffer => {
    const copy = whole.slice(0);
    new DataView(copy).setUint32(at, value, true);
    return copy;
  };

  test("what was cut at any place", () => {
    for (let length = 0; length < whole.byteLength; length += 1) {
      expect(readTrackPiece(whole.slice(0, length))).toBeNull();
    }
    expect(readTrackPiece(whole)).not.toBeNull();
  });

  test.each([
    ["another format", changed(0, 0x32545045)],
    ["a count that the bytes do not hold", changed(12, 3)],
    ["more points than there are", changed(16, 1)],
    ["a time that is none", changed(28, 0x7ff80000)],
    ["bytes behind the last point", new Uint8Array([...new Uint8Array(whole), 0]).buffer],
  ])("%s", (_, bytes) => {
    expect(readTrackPiece(bytes)).toBeNull();
  });
});

test.each([
  ["latitude_e7", 900_000_001],
  ["latitude_e7", -900_000_001],
  ["longitude_e7", 1_800_000_001],
])("a point with a %s of %i lies nowhere", (field, value) => {
  const piece = readTrackPiece(trackBytes([GANDO, { ...GANDO, [field]: value }]));
  expect([piece?.at(0) === null, piece?.at(1)]).toEqual([false, null]);
});
