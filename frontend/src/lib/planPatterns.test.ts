import { describe, expect, test } from "vitest";
import { PLAN_LIMITS } from "../protocol/missions";
import { bearing_deg, destination, distance_m, type Position } from "./geodesy";
import { captureRadius_m, type Waypoint } from "./plan";
import { checkPlan } from "./planCheck";
import {
  type Circuit,
  circuit,
  offset,
  type PlannedSurvey,
  type RunwayEnd,
  type Survey,
  survey,
} from "./planPatterns";

/** Repeatable chance: the same cases in each run. */
function random(seed: number): () => number {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1_664_525) + 1_013_904_223) >>> 0;
    return state / 2 ** 32;
  };
}

const CASES = 150;

/** The angle between two courses, 0..180. */
function turn_deg(one: number | null, other: number): number {
  return Math.abs((((((one ?? Number.NaN) - other + 180) % 360) + 360) % 360) - 180);
}

function runways(): ReadonlyArray<readonly [RunwayEnd, Circuit]> {
  const next = random(3);
  return Array.from({ length: CASES }, () => [
    {
      threshold: { latitude_deg: next() * 140 - 70, longitude_deg: next() * 360 - 180 },
      course_deg: next() * 360,
      length_m: 100 + next() * 3000,
      elevation_ft: next() * 3000,
    },
    {
      side: next() < 0.5 ? ("left" as const) : ("right" as const),
      height_ft: 300 + next() * 700,
      width_m: 400 + next() * 1500,
      upwind_m: 300 + next() * 1000,
      final_m: 700 + next() * 2000,
      pass_ft: 60 + next() * 200,
      speed_kt: 40 + next() * 15,
    },
  ]);
}

function at(plan: readonly Waypoint[], row: number): Waypoint {
  const waypoint = plan[row];
  if (waypoint === undefined) throw new Error(`no waypoint ${row}`);
  return waypoint;
}

describe("a circuit", () => {
  test("flies downwind against the runway's course, beside it on the wanted side, at its height", () => {
    for (const [runway, wanted] of runways()) {
      const plan = circuit(runway, wanted);
      const [turned, abeam] = [at(plan, 1), at(plan, 2)];
      expect(turn_deg(bearing_deg(turned, abeam), runway.course_deg + 180)).toBeLessThan(1);
      // A place is put down to 0.1 m.
      expect(Math.abs(distance_m(runway.threshold, abeam) - wanted.width_m)).toBeLessThan(1);
      const beside_deg = runway.course_deg + (wanted.side === "left" ? -90 : 90);
      expect(turn_deg(bearing_deg(runway.threshold, abeam), beside_deg)).toBeLessThan(0.1);
      expect(abeam.altitude_ft).toBeCloseTo(runway.elevation_ft + wanted.height_ft, -0.5);
    }
  });

  test("ends along the runway, at the threshold, no higher than any waypoint before", () => {
    for (const [runway, wanted] of runways()) {
      const plan = circuit(runway, wanted);
      expect(turn_deg(bearing_deg(at(plan, 4), at(plan, 5)), runway.course_deg)).toBeLessThan(0.2);
      expect(distance_m(at(plan, 5), runway.threshold)).toBeLessThan(0.2);
      const lowest_ft = Math.min(...plan.map(({ altitude_ft }) => altitude_ft));
      expect(at(plan, 5).altitude_ft).toBe(lowest_ft);
    }
  });

  test("as it is offered, at Gando, has neither fault nor warning", () => {
    const gando = { latitude_deg: 27.9189, longitude_deg: -15.3923 };
    const runway = { threshold: gando, course_deg: 21, length_m: 3100, elevation_ft: 78 };
    const wanted = { side: "right", height_ft: 700, width_m: 900, upwind_m: 500, final_m: 1500 } as const;
    expect(checkPlan(circuit(runway, { ...wanted, pass_ft: 200, speed_kt: 55 }), PLAN_LIMITS)).toEqual([]);
  });
});

/** Convex areas of 3..8 corners within 4 km. */
function areas(): ReadonlyArray<readonly [readonly Position[], Survey]> {
  const next = random(8);
  return Array.from({ length: CASES }, () => {
    const middle = { latitude_deg: next() * 140 - 70, longitude_deg: next() * 360 - 180 };
    const count = 3 + Math.floor(next() * 6);
    const radius_m = 500 + next() * 3500;
    const start = next() * 360;
    const corners = Array.from({ length: count }, (_, index) =>
      destination(middle, start + (index * 360) / count, radius_m),
    );
    return [
      corners,
      {
        spacing_m: 100 + next() * 900,
        angle_deg: next() * 360,
        overshoot_m: next() * 200,
        altitude_ft: 1000,
        speed_kt: 40 + next() * 40,
      },
    ];
  });
}

/** The survey's lines: each from one waypoint to the next, in metres along and across its angle from `origin`. */
function flat(origin: Position, angle_deg: number, place: Position): readonly [number, number] {
  const away_m = distance_m(origin, place);
  const angle = (((bearing_deg(origin, place) ?? 0) - angle_deg) * Math.PI) / 180;
  return [away_m * Math.cos(angle), away_m * Math.sin(angle)];
}

function linesOf(planned: PlannedSurvey | null) {
  const { waypoints, lines } = planned ?? { waypoints: [], lines: 0 };
  expect(waypoints).toHaveLength(2 * lines);
  return Array.from({ length: lines }, (_, line) => {
    const [from, to] = [at(waypoints, 2 * line), at(waypoints, 2 * line + 1)];
    return { length_m: distance_m(from, to), course_deg: bearing_deg(from, to) };
  });
}

function inside(corners: readonly (readonly [number, number])[], [x, y]: readonly [number, number]): boolean {
  const sides = corners.map(([ax, ay], index) => {
    const [bx, by] = corners[(index + 1) % corners.length] ?? [ax, ay];
    return (bx - ax) * (y - ay) - (by - ay) * (x - ax);
  });
  return sides.every((side) => side >= 0) || sides.every((side) => side <= 0);
}

describe("a survey", () => {
  test("leaves no place of the area farther from a line than half the spacing", () => {
    const next = random(21);
    for (const [corners, wanted] of areas()) {
      const { waypoints } = survey(corners, { ...wanted, overshoot_m: 0 }) ?? { waypoints: [] };
      const origin = at(waypoints, 0);
      const area = corners.map((corner) => flat(origin, wanted.angle_deg, corner));
      const across = waypoints.map((waypoint) => flat(origin, wanted.angle_deg, waypoint)[1]);
      const [least, most] = [
        [0, 1].map((of) => Math.min(...area.map((corner) => corner[of as 0 | 1]))),
        [0, 1].map((of) => Math.max(...area.map((corner) => corner[of as 0 | 1]))),
      ];
      for (let tried = 0; tried < 20; tried += 1) {
        const place = [0, 1].map(
          (of) => (least?.[of] ?? 0) + next() * ((most?.[of] ?? 0) - (least?.[of] ?? 0)),
        ) as [number, number];
        if (inside(area, place)) {
          const nearest_m = Math.min(...across.map((line) => Math.abs(line - place[1])));
          // The sphere bends a line of 8 km by a few metres against the grid.
          expect(nearest_m).toBeLessThanOrEqual(wanted.spacing_m / 2 + 8);
        }
      }
    }
  });

  test("has two waypoints a line, turned to and fro, beyond the area by what is wanted", () => {
    for (const [corners, wanted] of areas()) {
      const inner = linesOf(survey(corners, { ...wanted, overshoot_m: 0 }));
      const outer = linesOf(survey(corners, wanted));
      expect(outer).toHaveLength(inner.length);
      for (const [index, { length_m, course_deg }] of outer.entries()) {
        const longer_m = length_m - (inner[index]?.length_m ?? Number.NaN);
        expect(Math.abs(longer_m - 2 * wanted.overshoot_m)).toBeLessThan(1);
        const along_deg = wanted.angle_deg + (index % 2 === 0 ? 0 : 180);
        // A line that is hardly longer than a place is exact has no course to speak of.
        expect(length_m < 200 || turn_deg(course_deg, along_deg) < 2).toBe(true);
      }
    }
  });

  test("takes the next line where its beginning is not reached at the end of the one before", () => {
    for (const [corners, wanted] of areas()) {
      const planned = survey(corners, wanted);
      const { stride = 1 } = planned ?? {};
      const lines = (planned?.waypoints.length ?? 0) / 2;
      expect(
        stride === lines || stride * wanted.spacing_m >= captureRadius_m(wanted.speed_kt) || lines < 2,
      ).toBe(true);
    }
  });

  test("of a U flies over both arms and not between them", () => {
    const start = { latitude_deg: 28, longitude_deg: -15.4 };
    const corner = (along_m: number, across_m: number): Position => offset(start, 90, along_m, across_m);
    const shape = [
      corner(0, 0),
      corner(3000, 0),
      corner(3000, 2000),
      corner(2000, 2000),
      corner(2000, 500),
      corner(1000, 500),
      corner(1000, 2000),
      corner(0, 2000),
    ];
    const wanted = { spacing_m: 400, angle_deg: 90, overshoot_m: 0, altitude_ft: 900, speed_kt: 50 };
    const { waypoints } = survey(shape, wanted) ?? { waypoints: [] };
    // One line over the base, four over two arms.
    expect(waypoints).toHaveLength(2 + 4 * 4);
  });

  test("of two corners is the rectangle along its lines; of one or no room there is none", () => {
    const start = { latitude_deg: 28, longitude_deg: -15.4 };
    const wanted = { spacing_m: 250, angle_deg: 0, overshoot_m: 0, altitude_ft: 900, speed_kt: 50 };
    expect(survey([start, offset(start, 0, 1000, 1000)], wanted)?.lines).toBe(4);
    expect(survey([start], wanted)).toBeNull();
    expect(survey([start, start], wanted)).toBeNull();
    expect(survey([start, offset(start, 0, 1000, 1000)], { ...wanted, spacing_m: 0 })).toBeNull();
    expect(survey([start, offset(start, 0, 1e6, 1e6)], { ...wanted, spacing_m: 1 })).toBeNull();
  });
});
