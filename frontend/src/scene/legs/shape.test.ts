import { describe, expect, test } from "vitest";
import type { Waypoint } from "../../lib/plan";
import { type DrawnPlan, dotsOf, linesOf } from "./shape";

const waypoints: readonly Waypoint[] = [
  { latitude_deg: 27.95, longitude_deg: -15.37, altitude_ft: 700, speed_kt: 55 },
  { latitude_deg: 27.92, longitude_deg: -15.36, altitude_ft: 1000, speed_kt: 60 },
  { latitude_deg: 27.9, longitude_deg: -15.39, altitude_ft: 1000, speed_kt: 60 },
];

function drawn(plan: Partial<DrawnPlan> = {}): DrawnPlan {
  return {
    waypoints,
    board: null,
    unsent: waypoints.map(() => false),
    active: null,
    loops: false,
    turnBank_deg: null,
    selected: null,
    chosen: [],
    label: (waypoint, row) => `${row + 1} · ${waypoint.altitude_ft}`,
    ...plan,
  };
}

function kinds(plan: DrawnPlan): string[] {
  return linesOf(plan).map(({ kind }) => kind);
}

describe("the lines of a plan", () => {
  test("are its legs, a capture circle and a stem for each waypoint", () => {
    expect(kinds(drawn())).toEqual(["leg", "leg", "ring", "ring", "ring", "stem", "stem", "stem"]);
  });

  test("lie at the waypoints' altitudes in metres; stems go down to the sea", () => {
    const lines = linesOf(drawn());
    const top = { longitude_deg: -15.37, latitude_deg: 27.95, altitude_m: 700 * 0.3048 };
    expect(lines[0]?.places[0]).toEqual(top);
    expect(lines[2]?.places.every(({ altitude_m }) => altitude_m === top.altitude_m)).toBe(true);
    expect(lines[5]?.places).toEqual([{ ...top, altitude_m: 0 }, top]);
  });

  test("lead from the last waypoint to the first where the plan is a loop", () => {
    const [closing] = linesOf(drawn({ loops: true }));
    expect([closing?.places[0], closing?.places.at(-1)].map((place) => place?.longitude_deg)).toEqual([
      -15.39, -15.37,
    ]);
  });

  test("are the turns and the lines of capture where the line law flies", () => {
    expect(kinds(drawn({ turnBank_deg: 30 }))).toEqual([
      ...["leg", "leg", "turn", "ring", "ring", "stem", "stem", "stem"],
    ]);
    const closed = kinds(drawn({ turnBank_deg: 30, loops: true, active: 1 }));
    expect(closed.filter((kind) => kind === "turn")).toHaveLength(3);
    expect(closed.filter((kind) => kind === "activeRing")).toHaveLength(1);
  });

  test("make the leg that is flown stand out, with the circle at its end", () => {
    expect(kinds(drawn({ active: 1 })).filter((kind) => kind.startsWith("active"))).toEqual([
      "activeLeg",
      "activeRing",
    ]);
  });

  test("of what the board does not have are told apart, beside what it has, on which the flight is", () => {
    const plan = drawn({ board: waypoints.slice(0, 2), unsent: [false, false, true], active: 1 });
    expect(kinds(plan)).toEqual([
      ...["activeLeg", "leg", "unsentLeg", "ring", "ring", "ring", "activeRing", "stem", "stem", "stem"],
    ]);
    expect(dotsOf(plan).map(({ isActive }) => isActive)).toEqual([false, false, false]);
  });
});

test("a dot says what it is", () => {
  const [first, second] = dotsOf(drawn({ active: 0, selected: 1, unsent: [false, true, false] }));
  expect(first).toMatchObject({ label: "1 · 700", isActive: true, isSelected: false, isUnsent: false });
  expect(second).toMatchObject({ label: "2 · 1000", isActive: false, isSelected: true, isUnsent: true });
});
