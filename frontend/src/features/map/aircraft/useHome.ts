import { useMemo } from "react";
import type { Position } from "../../../lib/geodesy";
import { DEGREES_PER_UNIT } from "../../../lib/track/block";
import { usePart } from "../../../store/hooks";
import { TRACK_LOG, type TrackLog, useTracks } from "../track/trackLog";

export interface Home extends Position {
  /** The first known position of the flight, real or simulated; the runway until there is one. */
  readonly source: "first" | "firstHil" | "runway";
}

/** Gran Canaria's airport, where this project flies. */
const RUNWAY: Home = { latitude_deg: 27.9319, longitude_deg: -15.3866, source: "runway" };

/** Where the flight started, as far as is known. */
export function useHome(): Home {
  const { points } = usePart(TRACK_LOG);
  const flight_s = useTracks(({ summary }) => summary.flight.first_s);
  const hil_s = useTracks(({ summary }) => summary.hil.first_s);
  // biome-ignore lint/correctness/useExhaustiveDependencies: the first points change with their times
  return useMemo(
    () => firstOf(points.flight, "first") ?? firstOf(points.hil, "firstHil") ?? RUNWAY,
    [points, flight_s, hil_s],
  );
}

type Points = TrackLog["points"]["flight"];

function firstOf({ blocks }: Points, source: Home["source"]): Home | null {
  const latitude = blocks[0]?.latitude_e7[0];
  const longitude = blocks[0]?.longitude_e7[0];
  return blocks[0] === undefined || blocks[0].count === 0 || latitude === undefined || longitude === undefined
    ? null
    : { latitude_deg: latitude * DEGREES_PER_UNIT, longitude_deg: longitude * DEGREES_PER_UNIT, source };
}
