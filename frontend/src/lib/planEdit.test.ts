import { describe, expect, test } from "vitest";
import { flownHere } from "./flyHere";
import { bearing_deg, destination, distance_m } from "./geodesy";
import { legsOf, type Waypoint } from "./plan";
import {
  appended,
  bestRow,
  carried,
  insertedAt,
  insertedOnLeg,
  reversed,
  shifted,
  without,
  withSpeed,
} from "./planEdit";

/** Repeatable chance: the same plans in each run. */
function random(seed: number): () => number {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1_664_525) + 1_013_904_223) >>> 0;
    return state / 2 ** 32;
  };
}

/** A hundred plans of 2..20 waypoints within 20 km, anywhere but at the poles. */
function plans(): readonly (readonly Waypoint[])[] {
  const next = random(15);
  return Array.from({ length: 100 }, () => {
    const middle = { latitude_deg: next() * 140 - 70, longitude_deg: next() * 360 - 180 };
    return Array.from({ length: 2 + Math.floor(next() * 19) }, () => ({
      ...destination(middle, next() * 360, next() * 20_000),
      altitude_ft: Math.round(next() * 5000),
      speed_kt: Math.round(30 + next() * 60),
    }));
  });
}

const total_m = (plan: readonly Waypoint[]): number =>
  legsOf(plan).reduce((sum, leg) => sum + leg.distance_m, 0);

function at(plan: readonly Waypoint[], row: number): Waypoint {
  const waypoint = plan[row];
  if (waypoint === undefined) throw new Error(`no waypoint ${row}`);
  return waypoint;
}

describe("a plan that is turned round", () => {
  test("and round again is the same plan", () => {
    for (const plan of plans()) {
      expect(reversed(reversed(plan))).toEqual(plan);
    }
  });

  test("flies each leg at the speed that it had", () => {
    for (const plan of plans()) {
      const speeds = plan.slice(1).map(({ speed_kt }) => speed_kt);
      expect(
        reversed(plan)
          .slice(1)
          .map(({ speed_kt }) => speed_kt),
      ).toEqual(speeds.toReversed());
    }
  });
});

describe("a waypoint that is put in", () => {
  test("on a leg lies on it, at the altitude between, and makes the plan no longer", () => {
    const next = random(4);
    for (const plan of plans()) {
      const row = 1 + Math.floor(next() * (plan.length - 1));
      const share = next();
      const after = insertedOnLeg(plan, row, share);
      expect(after).toHaveLength(plan.length + 1);
      // Places are put down to 0.1 m.
      expect(Math.abs(total_m(after) - total_m(plan))).toBeLessThan(0.5);
      const [from, to] = [at(plan, row - 1), at(plan, row)];
      const planned_ft = from.altitude_ft + share * (to.altitude_ft - from.altitude_ft);
      expect(Math.abs(at(after, row).altitude_ft - planned_ft)).toBeLessThanOrEqual(1);
      expect(at(after, row).speed_kt).toBe(to.speed_kt);
    }
  });

  test("where it lengthens the way least lengthens it no more anywhere else", () => {
    const next = random(9);
    for (const plan of plans()) {
      const place = destination(at(plan, 0), next() * 360, next() * 20_000);
      const best = total_m(insertedAt(plan, bestRow(plan, place), place));
      for (let row = 0; row <= plan.length; row += 1) {
        expect(best).toBeLessThanOrEqual(total_m(insertedAt(plan, row, place)) + 0.5);
      }
    }
  });

  test("at the end takes altitude and speed of the last, and carries nothing else along", () => {
    const clicked = { latitude_deg: 27.9, longitude_deg: -15.4, height_m: 12 };
    const [plan = []] = plans();
    const last = at(plan, plan.length - 1);
    expect(appended(plan, clicked).at(-1)).toEqual({
      latitude_deg: 27.9,
      longitude_deg: -15.4,
      altitude_ft: last.altitude_ft,
      speed_kt: last.speed_kt,
    });
    expect(appended([], clicked)).toHaveLength(1);
  });
});

describe("several waypoints", () => {
  test("are carried by one of them alike: same way, same distance, same climb", () => {
    for (const plan of plans()) {
      const row = plan.length - 1;
      const from = at(plan, row);
      const to = { ...destination(from, 77, 850), altitude_ft: from.altitude_ft + 120 };
      const after = carried(plan, row, to, [0, row]);
      expect(distance_m(at(plan, 0), at(after, 0))).toBeCloseTo(850, 0);
      const course_deg = bearing_deg(at(plan, 0), at(after, 0)) ?? Number.NaN;
      expect(Math.abs(course_deg - (bearing_deg(from, to) ?? 0))).toBeLessThan(0.1);
      expect(at(after, 0).altitude_ft).toBeCloseTo(at(plan, 0).altitude_ft + 120, 6);
      expect(after.slice(1, row)).toEqual(plan.slice(1, row));
    }
  });

  test("that are not among the selected stay where they are", () => {
    const [plan = []] = plans();
    const to = { ...destination(at(plan, 0), 10, 300), altitude_ft: 500 };
    expect(carried(plan, 0, to, [1]).slice(1)).toEqual(plan.slice(1));
  });

  test("are displaced, taken out and given a speed together", () => {
    for (const plan of plans()) {
      const rows = [0, plan.length - 1];
      const up = shifted(plan, rows, { up_ft: 50 });
      expect(up.map(({ altitude_ft }, row) => altitude_ft - at(plan, row).altitude_ft)).toEqual(
        plan.map((_, row) => (rows.includes(row) ? 50 : 0)),
      );
      expect(without(plan, rows)).toEqual(plan.slice(1, -1));
      expect(
        withSpeed(plan, rows, 41).filter(({ speed_kt }) => speed_kt === 41).length,
      ).toBeGreaterThanOrEqual(2);
    }
    const [plan = []] = plans();
    expect(without(plan, [plan.length])).toBe(plan);
  });
});

describe("flying to a place", () => {
  const [plan = []] = plans();
  const place = { latitude_deg: 10, longitude_deg: 20 };

  test("and going on puts it before the waypoint that is flown to, and keeps all others", () => {
    const flown = flownHere(plan, 1, place, 800, "goOn");
    expect(flown?.row).toBe(1);
    expect(flown?.waypoints[1]).toEqual({ ...place, altitude_ft: 800, speed_kt: at(plan, 1).speed_kt });
    expect(without(flown?.waypoints ?? [], [1])).toEqual(plan);
  });

  test("and staying puts it last, where the board holds", () => {
    const flown = flownHere(plan, 1, place, 800, "stay");
    expect(flown?.row).toBe(plan.length);
    expect(flown?.waypoints.slice(0, -1)).toEqual(plan);
  });

  test("has nothing to go on to while nobody knows what is flown to, but can stay, also without a plan", () => {
    expect(flownHere(plan, null, place, 800, "goOn")).toBeNull();
    expect(flownHere([], null, place, 800, "stay")?.waypoints).toHaveLength(1);
  });
});
