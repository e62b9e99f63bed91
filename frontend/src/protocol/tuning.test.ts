import { expect, test } from "vitest";
import { AIRCRAFT } from "../lib/aircraft";
import { PARAMETERS } from "./messages.gen";
import { FIELD_KINDS } from "./topics";
import { LOOPS, loopOf, loopParameters, loopSignals } from "./tuning";

test("every parameter belongs to one loop", () => {
  const all = LOOPS.flatMap(loopParameters);
  expect([...all].sort()).toEqual(PARAMETERS.map(({ name }) => name).sort());
});

test.each([
  ["k_roll", "roll", ["simulator.roll_deg", "simulator.p_rad_s", "hil_surfaces.aileron"]],
  [
    "k_altura",
    "altitude",
    [
      "fms_hil_plan.altitude_ft",
      "simulator.altitude_indicated_ft",
      "simulator.vvi_ft_min",
      "simulator.pitch_deg",
    ],
  ],
] as const)("%s moves what its loop moves", (name, loop, signals) => {
  expect(loopOf(name)).toBe(loop);
  expect(loopSignals(loop, "hil").map(([, { topic, field }]) => `${topic}.${field}`)).toEqual(signals);
});

test("the real aircraft's signals are the board's own", () => {
  for (const loop of LOOPS) {
    for (const [, { topic }] of loopSignals(loop, "flight")) {
      expect(["simulator", "hil_surfaces", "fms_hil_plan"]).not.toContain(topic);
    }
  }
});

test("no loop asks for more than four units, which is what a plot has axes for", () => {
  for (const loop of LOOPS) {
    for (const aircraft of AIRCRAFT) {
      const units = new Set(loopSignals(loop, aircraft).map(([, { unit }]) => unit));
      expect(units.size).toBeLessThanOrEqual(4);
    }
  }
});

test("a signal in feet or degrees a second comes out of metres and radians", () => {
  const [, altitude] = loopSignals("altitude", "flight");
  expect(altitude?.[1].scale?.(304.8)).toBeCloseTo(1000, 9);
  const rate = loopSignals("roll", "hil")[1];
  expect(rate?.[1].scale?.(Math.PI)).toBeCloseTo(180, 9);
  expect(FIELD_KINDS.get("inertial")?.map(([field]) => field)).toContain("gx_rad_s");
});
