import { useState } from "react";
import { bearing_deg, distance_m, type Position } from "../../../lib/geodesy";
import type { RunwayEnd } from "../../../lib/planPatterns";
import { GRAN_CANARIA } from "../../../scene/globe/chart/airfields";
import { keptWorld } from "../../../scene/world/World";

/** A runway that the station knows, in one of its directions. */
export interface RunwayChoice {
  readonly id: string;
  /** Airfield and runway: "GCLP 03L". */
  readonly name: string;
  readonly runway: RunwayEnd;
}

/** Both ends of a runway: what is painted there, and where. */
type Ends = readonly [named: EndAt, other: EndAt];
interface EndAt {
  readonly name: string;
  readonly place: Position;
}

/** Airfields that are looked at: all those within sight of a field that is flown from. */
const LOOKED_AT = 8;
/** Nearer to each other than this the source has both ends in one place. */
const LEAST_LENGTH_M = 20;

/** Both directions of each runway of the airfield where the station's routes begin. */
export const RUNWAYS: readonly RunwayChoice[] = GRAN_CANARIA.runways.flatMap(({ ends: [first, second] }) =>
  directions(GRAN_CANARIA.code, GRAN_CANARIA.elevation_ft, [endAt(first), endAt(second)]),
);

export type RunwaySearch = "reading" | "none" | "failed" | null;

/** The runways to choose from, and `look`, which takes those of the airfields around a place instead. */
export function useRunways(): {
  readonly runways: readonly RunwayChoice[];
  readonly looking: RunwaySearch;
  readonly look: (around: Position) => Promise<readonly RunwayChoice[]>;
} {
  const [runways, setRunways] = useState(RUNWAYS);
  const [looking, setLooking] = useState<RunwaySearch>(null);
  const look = async (place: Position): Promise<readonly RunwayChoice[]> => {
    setLooking("reading");
    try {
      const found = await runwaysAround(place);
      setLooking(found.length === 0 ? "none" : null);
      if (found.length > 0) setRunways(found);
      return found;
    } catch {
      setLooking("failed");
      return [];
    }
  };
  return { runways, looking, look };
}

/** Both directions of each runway whose ends are known, the nearest airfield first. Rejects if the map cannot be read. */
async function runwaysAround(place: Position): Promise<readonly RunwayChoice[]> {
  const near = await keptWorld().ask<"near">({ kind: "near", place, most: LOOKED_AT });
  return near.flatMap(({ airfield: { code, elevation_ft, runways } }) =>
    (runways ?? []).flatMap(({ ends, places }) =>
      // Without its height above the sea a circuit would be flown at a height that nobody knows.
      places === null || elevation_ft === null
        ? []
        : directions(code, elevation_ft, [
            { name: ends[0], place: places[0] },
            { name: ends[1], place: places[1] },
          ]),
    ),
  );
}

function endAt({ name, latitude_deg, longitude_deg }: { name: string } & Position): EndAt {
  return { name, place: { latitude_deg, longitude_deg } };
}

function directions(code: string, elevation_ft: number, ends: Ends): readonly RunwayChoice[] {
  const [first, second] = ends;
  const length_m = distance_m(first.place, second.place);
  if (!(length_m > LEAST_LENGTH_M)) return [];
  const pairs = [[first, second] as const, [second, first] as const];
  return pairs.flatMap(([from, to]) => {
    const course_deg = bearing_deg(from.place, to.place);
    const name = `${code} ${from.name}`;
    const runway = { threshold: from.place, length_m, elevation_ft };
    return course_deg === null ? [] : [{ id: name, name, runway: { ...runway, course_deg } }];
  });
}
