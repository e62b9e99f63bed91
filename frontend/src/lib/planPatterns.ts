import { bearing_deg, destination, distance_m, type Position } from "./geodesy";
import { captureRadius_m, rounded, type Waypoint } from "./plan";
import { DEGREES_PER_RADIAN } from "./units";

/** One direction of a runway. */
export interface RunwayEnd {
  readonly threshold: Position;
  /** True course of take-off and landing. */
  readonly course_deg: number;
  readonly length_m: number;
  /** Above mean sea level. */
  readonly elevation_ft: number;
}

export interface Circuit {
  readonly side: "left" | "right";
  /** Of the downwind leg, above the field. */
  readonly height_ft: number;
  /** Distance of the downwind leg from the runway. */
  readonly width_m: number;
  /** From the end of the runway to the first turn. */
  readonly upwind_m: number;
  /** From the last turn to the threshold. */
  readonly final_m: number;
  /** Over the threshold, above the field: the last waypoint, where the board circles. */
  readonly pass_ft: number;
  readonly speed_kt: number;
}

/** Share of the circuit's height at the first turn, the turn to base and the turn to final. */
const FIRST_TURN = 0.7;
const BASE = 0.8;
const FINAL = 0.55;

/** The waypoints of an aerodrome circuit, from the first turn after take-off to over the threshold. */
export function circuit(runway: RunwayEnd, wanted: Circuit): readonly Waypoint[] {
  const { threshold, course_deg, length_m, elevation_ft } = runway;
  const { side, height_ft, width_m, upwind_m, final_m, pass_ft, speed_kt } = wanted;
  const across = side === "left" ? -width_m : width_m;
  const out_m = length_m + upwind_m;
  // Never below the last waypoint, also where that is put high.
  const share = (part: number): number => Math.max(part * height_ft, Math.min(pass_ft, height_ft));
  const corners: ReadonlyArray<readonly [along_m: number, across_m: number, height_ft: number]> = [
    [out_m, 0, share(FIRST_TURN)],
    [out_m, across, height_ft],
    [0, across, height_ft],
    [-final_m, across, share(BASE)],
    [-final_m, 0, share(FINAL)],
    [0, 0, pass_ft],
  ];
  return corners.map(([along_m, across_m, above_ft]) =>
    rounded({
      ...offset(threshold, course_deg, along_m, across_m),
      altitude_ft: elevation_ft + above_ft,
      speed_kt,
    }),
  );
}

/** The place so far along a course and so far to its right. */
export function offset(from: Position, course_deg: number, along_m: number, across_m: number): Position {
  const away_m = Math.hypot(along_m, across_m);
  return away_m === 0
    ? from
    : destination(from, course_deg + Math.atan2(across_m, along_m) * DEGREES_PER_RADIAN, away_m);
}

export interface Survey {
  /** Distance between lines. */
  readonly spacing_m: number;
  /** True course of the first line. */
  readonly angle_deg: number;
  /** How far each line goes beyond the area, for the turn. */
  readonly overshoot_m: number;
  readonly altitude_ft: number;
  readonly speed_kt: number;
}

export interface PlannedSurvey {
  readonly waypoints: readonly Waypoint[];
  readonly lines: number;
  /** A line is followed by the one so many lines away: neighbours may be nearer than an aircraft can turn. */
  readonly stride: number;
}

/** A hair more than whole spacings is no line more. */
const HAIR = 0.001;
/** Most lines that are worked out: far more than any plan has room for. */
const MOST_LINES = 2000;

/**
 * Parallel lines over an area, flown to and fro, so that each place in it is at most half a spacing from a line. Two
 * corners are those of a rectangle along the lines; null for fewer, or where spacing or area are nothing.
 */
export function survey(corners: readonly Position[], wanted: Survey): PlannedSurvey | null {
  const { spacing_m, angle_deg, overshoot_m, altitude_ft, speed_kt } = wanted;
  const middle = middleOf(corners);
  if (middle === null || !(spacing_m > 0)) {
    return null;
  }
  const seen = corners.map((corner) => toGrid(middle, angle_deg, corner));
  const area = seen.length === 2 ? rectangle(seen) : seen;
  const across = area.map(([, across_m]) => across_m);
  const [least, most] = [Math.min(...across), Math.max(...across)];
  const count = Math.max(1, Math.ceil((most - least) / spacing_m - HAIR));
  if (!(most > least) || count > MOST_LINES) {
    return null;
  }
  const first = (least + most - (count - 1) * spacing_m) / 2;
  const lines = Array.from({ length: count }, (_, index) => crossings(area, first + index * spacing_m));
  const stride = Math.min(count, Math.max(1, Math.ceil(TURN * (captureRadius_m(speed_kt) / spacing_m))));
  const flown = strided(lines, stride).filter((spans) => spans.length > 0);
  const waypoints = flown.flatMap((spans, index) => {
    const forth = spans.flatMap(({ from, to, across_m }) => [
      [from - overshoot_m, across_m] as const,
      [to + overshoot_m, across_m] as const,
    ]);
    return index % 2 === 0 ? forth : forth.toReversed();
  });
  return {
    waypoints: waypoints.map(([along_m, across_m]) =>
      rounded({ ...offset(middle, angle_deg, along_m, across_m), altitude_ft, speed_kt }),
    ),
    lines: flown.length,
    stride,
  };
}

/** The next line is at least so many capture radii away: nearer, its beginning would count as reached at once. */
const TURN = 1.05;

type GridPoint = readonly [along_m: number, across_m: number];

interface Span {
  readonly from: number;
  readonly to: number;
  readonly across_m: number;
}

function middleOf(corners: readonly Position[]): Position | null {
  const [start] = corners;
  if (start === undefined || corners.length < 2) {
    return null;
  }
  // Of metres from the first corner, which also holds where the date line is crossed.
  const places = corners.map((corner) => toGrid(start, 0, corner));
  const mean = (of: 0 | 1): number => places.reduce((sum, place) => sum + place[of], 0) / places.length;
  return offset(start, 0, mean(0), mean(1));
}

function toGrid(middle: Position, angle_deg: number, place: Position): GridPoint {
  const away_m = distance_m(middle, place);
  const angle = ((bearing_deg(middle, place) ?? 0) - angle_deg) / DEGREES_PER_RADIAN;
  return [away_m * Math.cos(angle), away_m * Math.sin(angle)];
}

function rectangle(corners: readonly GridPoint[]): readonly GridPoint[] {
  const along = corners.map(([along_m]) => along_m);
  const across = corners.map(([, across_m]) => across_m);
  const [a, b] = [Math.min(...along), Math.max(...along)];
  const [c, d] = [Math.min(...across), Math.max(...across)];
  return [
    [a, c],
    [b, c],
    [b, d],
    [a, d],
  ];
}

/** The parts of a line that lie in the area, in the line's direction. */
function crossings(area: readonly GridPoint[], across_m: number): readonly Span[] {
  const hits: number[] = [];
  for (const [index, [along, across]] of area.entries()) {
    const [nextAlong, nextAcross] = area[(index + 1) % area.length] ?? [along, across];
    // Half open: a corner that lies on the line belongs to one of its two edges.
    if (across > across_m !== nextAcross > across_m) {
      hits.push(along + ((across_m - across) / (nextAcross - across)) * (nextAlong - along));
    }
  }
  hits.sort((one, other) => one - other);
  const spans: Span[] = [];
  for (let at = 0; at + 1 < hits.length; at += 2) {
    const [from, to] = [hits[at], hits[at + 1]];
    if (from !== undefined && to !== undefined) {
      spans.push({ from, to, across_m });
    }
  }
  return spans;
}

/** Every `stride`-th line, then those beside them, and so on. */
function strided<T>(lines: readonly T[], stride: number): readonly T[] {
  return Array.from({ length: stride }, (_, start) =>
    lines.filter((_line, index) => index % stride === start),
  ).flat();
}
