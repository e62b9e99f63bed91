import { describe, expect, test } from "vitest";
import { readTerrainMesh } from "./terrainMesh";

/** A tile as the format asks for it: a grid of `side` points a side with these heights, from the south-west. */
function tile(side: number, heights_m: readonly number[]): ArrayBuffer {
  const [least_m, most_m] = [Math.min(...heights_m), Math.max(...heights_m)];
  const spread_m = most_m - least_m || 1;
  const points = heights_m.map((height_m, at) => ({
    u: Math.round(((at % side) * 32_767) / (side - 1)),
    v: Math.round((Math.floor(at / side) * 32_767) / (side - 1)),
    height: Math.round(((height_m - least_m) * 32_767) / spread_m),
  }));
  const cells = Array.from({ length: (side - 1) ** 2 }, (_, cell) => {
    const corner = Math.floor(cell / (side - 1)) * side + (cell % (side - 1));
    return [corner, corner + 1, corner + side + 1, corner, corner + side + 1, corner + side];
  }).flat();
  // Vertices in the order of their first use, as the indices' encoding asks.
  const order = [...new Set(cells)];
  const bytes = new DataView(new ArrayBuffer(92 + 6 * order.length + 4 + 2 * cells.length));
  bytes.setFloat32(24, least_m, true);
  bytes.setFloat32(28, least_m + spread_m, true);
  bytes.setUint32(88, order.length, true);
  let at = 92;
  for (const field of ["u", "v", "height"] as const) {
    let before = 0;
    for (const point of order) {
      const step = (points[point]?.[field] ?? 0) - before;
      before += step;
      bytes.setUint16(at, (step << 1) ^ (step >> 31), true);
      at += 2;
    }
  }
  bytes.setUint32(at, cells.length / 3, true);
  at += 4;
  let highest = 0;
  for (const point of cells) {
    const code = highest - order.indexOf(point);
    bytes.setUint16(at, code, true);
    highest += code === 0 ? 1 : 0;
    at += 2;
  }
  return bytes.buffer;
}

const SLOPE = Array.from({ length: 25 }, (_, at) => 100 + 40 * (at % 5) + 10 * Math.floor(at / 5));

describe("a tile of terrain", () => {
  test("gives the height of the plane between its points, anywhere in it", () => {
    const mesh = readTerrainMesh(tile(5, SLOPE));
    for (const [u, v] of [
      [0, 0],
      [1, 1],
      [0.5, 0.5],
      [0.13, 0.87],
      [0.99, 0.01],
    ] as const) {
      expect(mesh?.heightAt(u, v)).toBeCloseTo(100 + 160 * u + 40 * v, 0);
    }
  });

  test("of one height has it everywhere, and none outside", () => {
    const mesh = readTerrainMesh(tile(3, Array(9).fill(42)));
    expect(mesh?.heightAt(0.3, 0.6)).toBeCloseTo(42, 3);
    expect(mesh?.heightAt(1.2, 0.6)).toBeNull();
  });

  test("that is cut anywhere is none, or still whole", () => {
    const whole = tile(5, SLOPE);
    for (let length = 0; length < whole.byteLength; length += 7) {
      expect(readTerrainMesh(whole.slice(0, length))).toBeNull();
    }
  });

  test("whose indices point beyond its points is none", () => {
    const broken = tile(3, Array(9).fill(5));
    new DataView(broken).setUint16(92 + 54 + 4 + 6, 60_000, true);
    expect(readTerrainMesh(broken)).toBeNull();
  });
});
