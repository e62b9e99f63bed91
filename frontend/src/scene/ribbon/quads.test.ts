import { expect, test } from "vitest";
import { CORNERS, cornerIndices, INDICES, spread } from "./quads";
import { POINT_FLOATS } from "./vertices";

/** Points that differ in every number. */
function line(count: number): Float32Array {
  return Float32Array.from({ length: count * POINT_FLOATS }, (_, at) => at + 1);
}

test("each corner of a rectangle finds its own point, and the next one behind it", () => {
  const points = line(3);
  const vertices = spread(points, new Float32Array(10 * CORNERS * POINT_FLOATS));
  expect(vertices.length).toBe(3 * CORNERS * POINT_FLOATS);
  for (const vertex of cornerIndices(2)) {
    const from = Math.floor(vertex / CORNERS);
    const own = vertices.subarray(vertex * POINT_FLOATS, (vertex + 1) * POINT_FLOATS);
    const next = vertices.subarray((vertex + CORNERS) * POINT_FLOATS, (vertex + CORNERS + 1) * POINT_FLOATS);
    expect([...own]).toEqual([...points.subarray(from * POINT_FLOATS, (from + 1) * POINT_FLOATS)]);
    expect([...next]).toEqual([...points.subarray((from + 1) * POINT_FLOATS, (from + 2) * POINT_FLOATS)]);
  }
});

test("two triangles of a rectangle cover its four corners, and share one side", () => {
  const indices = [...cornerIndices(3)];
  expect(indices.length).toBe(3 * INDICES);
  const last = indices.slice(2 * INDICES).map((index) => index - 2 * CORNERS);
  expect(new Set(last)).toEqual(new Set([0, 1, 2, 3]));
  const [one, other] = [last.slice(0, 3), last.slice(3)];
  expect(one.filter((corner) => other.includes(corner))).toHaveLength(2);
});
