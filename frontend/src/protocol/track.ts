import type { TrackPoint } from "../lib/track/trackPoints";

/** Points of a track from one index on. */
export interface TrackPiece {
  /** Another number: points which were known are no longer as they were. */
  readonly epoch: number;
  readonly first: number;
  readonly count: number;
  /** As many as the gateway had when it answered. */
  readonly total: number;
  /** A point by its place in this piece, or null when it lies nowhere on earth. */
  readonly at: (place: number) => TrackPoint | null;
}

const MAGIC = 0x31545045; // "EPT1", little endian
const HEADER_BYTES = 32;
const POINT_BYTES = 16;
const POLE_E7 = 90e7;
const DATE_LINE_E7 = 180e7;

/** The gateway's bytes as a piece, or null when they are not whole or not what was agreed. */
export function readTrackPiece(bytes: ArrayBuffer): TrackPiece | null {
  if (bytes.byteLength < HEADER_BYTES) {
    return null;
  }
  const view = new DataView(bytes);
  const u32 = (at: number): number => view.getUint32(at, true);
  const [epoch, first, count, total] = [u32(4), u32(8), u32(12), u32(16)];
  const t0_s = view.getFloat64(24, true);
  if (
    u32(0) !== MAGIC ||
    bytes.byteLength !== HEADER_BYTES + count * POINT_BYTES ||
    first + count > total ||
    !(Number.isFinite(t0_s) && t0_s >= 0)
  ) {
    return null;
  }
  const at = (place: number): TrackPoint | null => {
    const begin = HEADER_BYTES + place * POINT_BYTES;
    const latitude_e7 = view.getInt32(begin + 4, true);
    const longitude_e7 = view.getInt32(begin + 8, true);
    return Math.abs(latitude_e7) > POLE_E7 || Math.abs(longitude_e7) > DATE_LINE_E7
      ? null
      : {
          t_s: t0_s + u32(begin) / 1000,
          latitude_e7,
          longitude_e7,
          altitude_mm: view.getInt32(begin + 12, true),
        };
  };
  return { epoch, first, count, total, at };
}
