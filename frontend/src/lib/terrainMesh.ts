/** A tile of terrain as the globe's engine reads it (quantized-mesh 1.0), asked for its height at a place. */
export interface TerrainMesh {
  /** Height in metres above the sea at a place of the tile, 0..1 from the west and from the south; null: no triangle. */
  readonly heightAt: (u: number, v: number) => number | null;
}

const LEAST_HEIGHT_AT = 24;
const MOST_HEIGHT_AT = 28;
const VERTICES_AT = 88;
const LARGEST = 32_767;
/** Above this many vertices the file's indices have four bytes. */
const SHORT_INDICES = 65_536;
/** A place on a common edge of two triangles is in one of them, whatever the rounding. */
const EDGE = -1e-9;

/** Reads a tile; null if it is none, or is cut off. */
export function readTerrainMesh(bytes: ArrayBuffer): TerrainMesh | null {
  const view = new DataView(bytes);
  if (bytes.byteLength < VERTICES_AT + 4) {
    return null;
  }
  const count = view.getUint32(VERTICES_AT, true);
  const isLong = count > SHORT_INDICES;
  const width = isLong ? 4 : 2;
  let at = VERTICES_AT + 4 + 6 * count;
  at += isLong ? (4 - (at % 4)) % 4 : 0;
  if (count === 0 || at + 4 > bytes.byteLength) {
    return null;
  }
  const triangles = view.getUint32(at, true);
  at += 4;
  if (at + 3 * width * triangles > bytes.byteLength) {
    return null;
  }
  const corners = [0, 1, 2].map((which) => unzigzag(view, VERTICES_AT + 4 + 2 * count * which, count));
  const indices = unmarked(view, at, 3 * triangles, width);
  const [u, v, heights] = corners;
  if (
    u === undefined ||
    v === undefined ||
    heights === undefined ||
    indices.some((index) => index >= count)
  ) {
    return null;
  }
  const least_m = view.getFloat32(LEAST_HEIGHT_AT, true);
  const span_m = view.getFloat32(MOST_HEIGHT_AT, true) - least_m;
  return {
    heightAt: (x, y) => {
      const share = heightIn(u, v, heights, indices, x * LARGEST, y * LARGEST);
      return share === null ? null : least_m + (share / LARGEST) * span_m;
    },
  };
}

/** Differences of neighbours in zigzag encoding. */
function unzigzag(view: DataView, from: number, count: number): Float64Array {
  const values = new Float64Array(count);
  let value = 0;
  for (let index = 0; index < count; index += 1) {
    const code = view.getUint16(from + 2 * index, true);
    value += (code >> 1) ^ -(code & 1);
    values[index] = value;
  }
  return values;
}

/** High-water-mark encoding: each index is so far below the next that was not used yet. */
function unmarked(view: DataView, from: number, count: number, width: 2 | 4): Uint32Array {
  const indices = new Uint32Array(count);
  let highest = 0;
  for (let index = 0; index < count; index += 1) {
    const at = from + width * index;
    const code = width === 4 ? view.getUint32(at, true) : view.getUint16(at, true);
    indices[index] = highest - code;
    highest += code === 0 ? 1 : 0;
  }
  return indices;
}

function heightIn(
  u: Float64Array,
  v: Float64Array,
  heights: Float64Array,
  indices: Uint32Array,
  x: number,
  y: number,
): number | null {
  const of = (values: Float64Array, index: number): number => values[indices[index] ?? 0] ?? 0;
  for (let at = 0; at < indices.length; at += 3) {
    const [ax, bx, cx] = [of(u, at), of(u, at + 1), of(u, at + 2)];
    const [ay, by, cy] = [of(v, at), of(v, at + 1), of(v, at + 2)];
    const whole = (by - cy) * (ax - cx) + (cx - bx) * (ay - cy);
    const a = ((by - cy) * (x - cx) + (cx - bx) * (y - cy)) / whole;
    const b = ((cy - ay) * (x - cx) + (ax - cx) * (y - cy)) / whole;
    const c = 1 - a - b;
    if (a >= EDGE && b >= EDGE && c >= EDGE) {
      return a * of(heights, at) + b * of(heights, at + 1) + c * of(heights, at + 2);
    }
  }
  return null;
}
