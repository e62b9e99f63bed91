import { describe, expect, test } from "vitest";
import { aStatus } from "../test/aStatus";
import { anEvent, aShape } from "../test/shapes";
import { parseMessage } from "./envelope";

function parse(message: unknown) {
  return parseMessage(JSON.stringify(message));
}

const ahrs = { topic: "ahrs", t_s: 1700000000.5, values: { yaw_deg: 12.5, pitch_deg: null, roll_deg: -3 } };
const batch = { type: "batch", seq: 3, t_s: 1700000000.6, missed: 0, missed_events: 0, samples: [ahrs] };
const jumped = anEvent("simulator_jumped", aShape("SimulatorJumpEvent"));
const hello = {
  type: "hello",
  version: "0.1.0",
  client: "c1",
  role: "operator",
  server_time_s: 1700000000,
  topics: ["ahrs"],
  status: aStatus(),
};

describe("a message as agreed", () => {
  test("a batch gives its samples, null as no data", () => {
    expect(parse(batch)).toMatchObject({ type: "batch", seq: 3, samples: [ahrs] });
  });

  test("a hello gives name, role and clock", () => {
    expect(parse(hello)).toMatchObject({
      type: "hello",
      client: "c1",
      role: "operator",
      server_time_s: 1700000000,
    });
  });

  test("a status and an event pass", () => {
    expect(parse({ type: "status", data: aStatus() })?.type).toBe("status");
    const command = anEvent("command", aShape("CommandEvent", { name: "ahrs_on" }));
    expect(parse(command)).toEqual(command);
  });

  test.each(["added_later", "toString"])("an event that this page does not know, %s, has no name", (name) => {
    expect(parse({ type: "event", event: name, t_s: 1, data: { any: 1 } })).toMatchObject({ event: null });
  });

  test("the simulator's rows come apart from the samples, a value that is not there as no data", () => {
    const rows = {
      topic: "xplane_rows",
      t_s: 1700000000.5,
      values: { rows: { 3: [55, -999, null], 17: [1.5] } },
    };
    expect(parse({ ...batch, samples: [rows, ahrs] })).toMatchObject({
      samples: [ahrs],
      rows: {
        t_s: 1700000000.5,
        rows: [
          [3, [55, null, null]],
          [17, [1.5]],
        ],
      },
    });
    expect(parse(batch)).toMatchObject({ rows: null });
  });

  test("a topic that this page does not know may hold anything", () => {
    const sample = { topic: "added_later", t_s: 1, values: { rows: { 3: [1, 2] } } };
    expect(parse({ ...batch, samples: [sample] })?.type).toBe("batch");
  });

  test("a field that this page does not know does no harm", () => {
    const sample = { ...ahrs, values: { ...ahrs.values, added_later: "text" } };
    expect(parse({ ...batch, samples: [sample] })?.type).toBe("batch");
  });
});

describe("refused as a whole is", () => {
  test.each([
    ["no JSON", "{"],
    ["JSON that is no object", "[1]"],
    ["a kind that nobody agreed on", JSON.stringify({ type: "surprise" })],
    ["a batch without number", JSON.stringify({ ...batch, seq: null })],
    ["a batch without samples", JSON.stringify({ ...batch, samples: {} })],
    ["a sample without time", JSON.stringify({ ...batch, samples: [{ ...ahrs, t_s: "now" }] })],
    [
      "a number that is text",
      JSON.stringify({ ...batch, samples: [{ ...ahrs, values: { ...ahrs.values, roll_deg: "3" } }] }),
    ],
    ["a number without end", JSON.stringify(batch).replace("12.5", "1e999")],
    [
      "a missing field",
      JSON.stringify({ ...batch, samples: [{ ...ahrs, values: { yaw_deg: 1, pitch_deg: 1 } }] }),
    ],
    [
      "a flag that is a number",
      JSON.stringify({ ...batch, samples: [{ topic: "heartbeat", t_s: 1, values: { ahrs: 1 } }] }),
    ],
    [
      "a row of the simulator that is no list",
      JSON.stringify({ ...batch, samples: [{ topic: "xplane_rows", t_s: 1, values: { rows: { 3: 55 } } }] }),
    ],
    [
      "a row of the simulator without a number",
      JSON.stringify({
        ...batch,
        samples: [{ topic: "xplane_rows", t_s: 1, values: { rows: { one: [] } } }],
      }),
    ],
    ["an event without time", JSON.stringify({ ...jumped, t_s: null })],
    ["an event whose data is not as agreed", JSON.stringify({ ...jumped, data: { distance_m: "far" } })],
    ["a hello with an unknown role", JSON.stringify({ ...hello, role: "captain" })],
    [
      "a status with a board in no known state",
      JSON.stringify({
        type: "status",
        data: aStatus({ board: { ...aStatus().board, state: "odd" as never } }),
      }),
    ],
  ])("%s", (_, text) => {
    expect(parseMessage(text)).toBeNull();
  });
});
