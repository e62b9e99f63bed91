import { isNumber } from "../lib/check";
import type { Problem } from "../protocol/answers";
import type { Asker } from "../requests/asking";

/** What a person answered about a file; the file is read again with it. */
export interface ImportAnswers {
  /** Home's altitude, feet above mean sea level. */
  readonly home_ft?: number;
  /** A flown track is wanted as a plan. */
  readonly thin?: true;
}

/** Something about a file that only a person can say. */
export type ImportQuestion = {
  readonly file: File;
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
  | {
      readonly kind: "track";
      readonly points: number;
      readonly waypoints: number;
      readonly deviation_m: number;
    }
);

/** The question in the gateway's refusal of a file; null if it is no question. */
export function questionIn(
  { code, params }: Problem,
  about: Pick<ImportQuestion, "file" | "asker" | "answers">,
): ImportQuestion | null {
  const figure = (name: string): number | null => {
    const value = params[name];
    return isNumber(value) ? value : null;
  };
  if (code === "mission_file_no_home" && about.answers.home_ft === undefined) {
    return { ...about, kind: "home", count: figure("count") ?? 0, ground_ft: figure("ground_ft") };
  }
  const [points, waypoints, deviation_m] = [figure("points"), figure("waypoints"), figure("deviation_m")];
  return code === "mission_file_track" && points !== null && waypoints !== null && deviation_m !== null
    ? { ...about, kind: "track", points, waypoints, deviation_m }
    : null;
}
