import { isNumber } from "../lib/check";
import type { Problem } from "../protocol/answers";
import type { PlanName } from "../protocol/missions";
import type { Asker } from "../requests/asking";

/** A flight of the library, of which one track is to become a plan. */
export interface FlownTrack {
  /** What people call the flight. */
  readonly name: string;
  readonly flight: string;
  readonly track: PlanName;
}

/** What a plan is read from. */
export type PlanSource = File | FlownTrack;

/** What a person answered about a source; it is read again with it. */
export interface ImportAnswers {
  /** Home's altitude, feet above mean sea level. */
  readonly home_ft?: number;
  /** A flown track is wanted as a plan. */
  readonly thin?: true;
  /** What item 0 of a .waypoints is. */
  readonly first?: "home" | "waypoint";
}

/** Something about a source that only a person can say. */
export type ImportQuestion = {
  readonly source: PlanSource;
  readonly asker: Asker;
  readonly answers: ImportAnswers;
} & (
  | {
      readonly kind: "home";
      /** Waypoints whose heights count from home. */
      readonly count: number;
      /** The ground's altitude at the first waypoint, feet above mean sea level; null: not known. */
      readonly ground_ft: number | null;
    }
  | { readonly kind: "first" }
  | {
      readonly kind: "track";
      readonly points: number;
      readonly waypoints: number;
      readonly deviation_m: number;
    }
);

/** Where it is read, with the answers. */
export function importPath(source: PlanSource, { home_ft, thin, first }: ImportAnswers): string {
  const thinned = thin ? "&thin=true" : "";
  if ("flight" in source) {
    return `/api/v1/flights/${source.flight}/plan?source=${source.track}${thinned}`;
  }
  const home = home_ft === undefined ? "" : `&home_ft=${home_ft}`;
  const item0 = first === undefined ? "" : `&first=${first}`;
  return `/api/v1/missions/import?name=${encodeURIComponent(source.name)}${home}${thinned}${item0}`;
}

/** The question in the gateway's refusal of a source; null if it is no question. */
export function questionIn(
  { code, params }: Problem,
  about: Pick<ImportQuestion, "source" | "asker" | "answers">,
): ImportQuestion | null {
  const figure = (name: string): number | null => {
    const value = params[name];
    return isNumber(value) ? value : null;
  };
  if (code === "mission_file_no_home" && about.answers.home_ft === undefined) {
    return { ...about, kind: "home", count: figure("count") ?? 0, ground_ft: figure("ground_ft") };
  }
  if (code === "mission_file_home_unclear") {
    return { ...about, kind: "first" };
  }
  const [points, waypoints, deviation_m] = [figure("points"), figure("waypoints"), figure("deviation_m")];
  return code === "mission_file_track" && points !== null && waypoints !== null && deviation_m !== null
    ? { ...about, kind: "track", points, waypoints, deviation_m }
    : null;
}
