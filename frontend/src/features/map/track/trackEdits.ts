import { type Asker, createAsking, info, type RequesterParts } from "../../../requests/asking";
import { partName } from "../../../store/parts";

/** Clears and restores the tracks, for every browser; none throws. */
export interface TrackEdits {
  readonly reset: (asker: Asker) => Promise<void>;
  readonly restore: (asker: Asker) => Promise<void>;
}

export const TRACK_EDITS = partName<TrackEdits>("track edits");

export function createTrackEdits(parts: RequesterParts): TrackEdits {
  const { simply } = createAsking(parts);
  return {
    reset: (asker) => simply(asker, ["POST", "/api/v1/track/reset"], info("said.trackReset")),
    restore: (asker) => simply(asker, ["POST", "/api/v1/track/restore"], info("said.trackRestored")),
  };
}
