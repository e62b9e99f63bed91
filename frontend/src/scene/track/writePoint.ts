import { DEGREES_PER_UNIT, METRES_PER_UNIT, type TrackBlock } from "../../lib/track/block";
import { beginPiece, writePlace, writeRates } from "../ribbon/vertices";

/** The block's point at `offset` as vertex `at`. */
export function writePoint(into: Float32Array, at: number, block: TrackBlock, offset: number): void {
  writePlace(into, at, {
    latitude_deg: (block.latitude_e7[offset] ?? 0) * DEGREES_PER_UNIT,
    longitude_deg: (block.longitude_e7[offset] ?? 0) * DEGREES_PER_UNIT,
    altitude_m: (block.altitude_mm[offset] ?? 0) * METRES_PER_UNIT,
  });
  writeRates(into, at, block.speed_mps[offset], block.climb_mps[offset]);
  if (block.starts.includes(offset)) {
    beginPiece(into, at);
  }
}
