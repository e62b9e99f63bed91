import { POINT_FLOATS } from "./vertices";

/** Corners of the rectangle between two points; the shaders number them: sides first, then ends. */
export const CORNERS = 4;
/** Two triangles. */
export const INDICES = 6;
const TRIANGLES = [0, 1, 2, 2, 1, 3] as const;

/** Writes each point once per corner to `into`; returns the written part. */
export function spread(points: Float32Array, into: Float32Array): Float32Array {
  let at = 0;
  for (let begin = 0; begin < points.length; begin += POINT_FLOATS) {
    for (let corner = 0; corner < CORNERS; corner += 1) {
      for (let part = 0; part < POINT_FLOATS; part += 1) {
        into[at] = points[begin + part] ?? 0;
        at += 1;
      }
    }
  }
  return into.subarray(0, at);
}

/** The corner indices of the triangles of this many rectangles. */
export function cornerIndices(rectangles: number): Uint32Array {
  const indices = new Uint32Array(rectangles * INDICES);
  for (let at = 0; at < indices.length; at += 1) {
    indices[at] = CORNERS * Math.floor(at / INDICES) + (TRIANGLES[at % INDICES] ?? 0);
  }
  return indices;
}
