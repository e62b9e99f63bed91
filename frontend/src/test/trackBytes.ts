/** A point as the gateway packs it. */
export interface PackedPoint {
  readonly t_ms: number;
  readonly latitude_e7: number;
  readonly longitude_e7: number;
  readonly altitude_mm: number;
}

interface Header {
  readonly epoch?: number;
  readonly first?: number;
  readonly total?: number;
  readonly t0_s?: number;
}

/** The gateway's answer to a request for points of a track. */
export function trackBytes(points: readonly PackedPoint[], header: Header = {}): ArrayBuffer {
  const { epoch = 1, first = 0, total = first + points.length, t0_s = 1_700_000_000 } = header;
  const bytes = new ArrayBuffer(32 + 16 * points.length);
  const view = new DataView(bytes);
  for (const [at, letter] of [..."EPT1"].entries()) {
    view.setUint8(at, letter.charCodeAt(0));
  }
  for (const [at, value] of [epoch, first, points.length, total].entries()) {
    view.setUint32(4 + 4 * at, value, true);
  }
  view.setFloat64(24, t0_s, true);
  for (const [at, { t_ms, latitude_e7, longitude_e7, altitude_mm }] of points.entries()) {
    view.setUint32(32 + 16 * at, t_ms, true);
    view.setInt32(36 + 16 * at, latitude_e7, true);
    view.setInt32(40 + 16 * at, longitude_e7, true);
    view.setInt32(44 + 16 * at, altitude_mm, true);
  }
  return bytes;
}

/** Points of a flight to the north, 50 a second. */
export function packedFlight(first: number, count: number): PackedPoint[] {
  return Array.from({ length: count }, (_, at) => ({
    t_ms: (first + at) * 20,
    latitude_e7: 279_300_000 + (first + at) * 54,
    longitude_e7: -153_800_000,
    altitude_mm: 100_000 + (first + at) * 20,
  }));
}
