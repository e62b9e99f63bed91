import type { Position } from "../../../lib/geodesy";
import type { RunwayEnd } from "../../../lib/planPatterns";
import { GRAN_CANARIA, runwayCourse } from "../../../scene/globe/chart/airfields";

/** A runway that the station knows, in one of its directions. */
export interface RunwayChoice {
  readonly id: string;
  /** Airfield and runway: "GCLP 03L". */
  readonly name: string;
  readonly runway: RunwayEnd;
}

/** Both directions of each runway of the station's airfield. */
export const RUNWAYS: readonly RunwayChoice[] = GRAN_CANARIA.runways.flatMap((runway) => {
  const { length_m, bearing_deg } = runwayCourse(runway);
  const [first, second] = runway.ends;
  const choice = (name: string, threshold: Position, course_deg: number): RunwayChoice => ({
    id: `${GRAN_CANARIA.code} ${name}`,
    name: `${GRAN_CANARIA.code} ${name}`,
    runway: {
      threshold: { latitude_deg: threshold.latitude_deg, longitude_deg: threshold.longitude_deg },
      course_deg: (course_deg + 360) % 360,
      length_m,
      elevation_ft: GRAN_CANARIA.elevation_ft,
    },
  });
  return [choice(first.name, first, bearing_deg), choice(second.name, second, bearing_deg + 180)];
});
