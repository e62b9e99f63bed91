import { expect, test } from "vitest";
import type { InspectedFrame, InspectedRow } from "../../protocol/contract";
import { frameLine, ownUnits, rowLine } from "./lines";

const frame: InspectedFrame = {
  id: 1,
  name: "ahrs",
  count: 100,
  rate_hz: 10,
  jitter_ms: 1.5,
  damaged: 2,
  age_s: 0.05,
  stale_after_s: 0.3,
  values: { yaw_deg: -15.374123, pitch_deg: null, roll_deg: 0 },
  units: { yaw_deg: "deg", pitch_deg: "deg", roll_deg: "deg" },
};
const row: InspectedRow = {
  row: 17,
  name: "attitude",
  expected: true,
  count: 50,
  rate_hz: 50,
  jitter_ms: null,
  age_s: 0.02,
  values: [1.25, -999, null, 0, 0, 0, 0, 0],
};

test("a frame's values keep the figures of the wire, and what is none is no data", () => {
  expect(frameLine(frame).values).toEqual([
    { name: "yaw_deg", value: "-15.37412", unit: "°", plotKey: "ahrs.yaw_deg" },
    { name: "pitch_deg", value: null, unit: "°", plotKey: "ahrs.pitch_deg" },
    { name: "roll_deg", value: "0", unit: "°", plotKey: "ahrs.roll_deg" },
  ]);
});

test("a topic that the board describes has its own units, and its numbers can be drawn", () => {
  const own: InspectedFrame = {
    ...frame,
    id: 0x1000,
    name: "filter",
    values: { force: 1.5, temperature: null, is_settled: true },
    units: { force: "N", temperature: "degC", is_settled: "1" },
  };
  expect(frameLine(own).values).toEqual([
    { name: "force", value: "1.500000", unit: "N", plotKey: "own.filter.force" },
    { name: "temperature", value: null, unit: "°C", plotKey: "own.filter.temperature" },
    { name: "is_settled", value: true, unit: "", plotKey: null },
  ]);
  expect(ownUnits([frame, own]).get("own.filter.temperature")).toBe("°C");
});

test("a frame is stale once it is older than its stream allows, and not when it is no stream", () => {
  expect(frameLine(frame).state).toBe("live");
  expect(frameLine({ ...frame, age_s: 0.31 }).state).toBe("stale");
  expect(frameLine({ ...frame, age_s: 500, stale_after_s: null }).state).toBe("live");
  expect(frameLine({ ...frame, age_s: null, values: null })).toMatchObject({ state: "none", values: [] });
});

test("an extension's number is written as the protocol writes it", () => {
  expect([frameLine(frame).id, frameLine({ ...frame, id: 0x102 }).id]).toEqual(["1", "0x102"]);
});

test("a flag stays a flag, and of a frame without a stream nothing can be drawn", () => {
  const other = frameLine({
    ...frame,
    name: "capabilities",
    values: { has_store: true, protocol_version: 1 },
  });
  expect(other.values).toEqual([
    { name: "has_store", value: true, unit: "", plotKey: null },
    { name: "protocol_version", value: "1", unit: "", plotKey: null },
  ]);
});

test("a row's values are named where the definition knows them; -999 is no data", () => {
  const { values, isNeeded, state } = rowLine(row, "xp10");
  expect(values.slice(0, 4)).toEqual([
    { name: "0 pitch_deg", value: "1.250000", unit: "°", plotKey: "row.17.0" },
    { name: "1 roll_deg", value: null, unit: "°", plotKey: "row.17.1" },
    { name: "2 true_heading_deg", value: null, unit: "°", plotKey: "row.17.2" },
    { name: "3", value: "0", unit: "", plotKey: "row.17.3" },
  ]);
  expect([isNeeded, state, rowLine({ ...row, age_s: 1.2 }, "xp10").state]).toEqual([true, "live", "stale"]);
});
