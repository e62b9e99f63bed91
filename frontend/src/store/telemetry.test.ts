import { beforeEach, describe, expect, test } from "vitest";
import { SILENCE_MS, TelemetryStore } from "./telemetry";

const START_S = 1_700_000_000;
let telemetry: TelemetryStore;

/** A sample of ahrs that reached the gateway `age_s` before the batch was made; the page's clock shows `now_ms`. */
function batch(now_ms: number, age_s = 0, values = { roll_deg: 30 }): void {
  const made_s = START_S + now_ms / 1000;
  telemetry.apply(made_s, [{ topic: "ahrs", t_s: made_s - age_s, values }], now_ms);
}

beforeEach(() => {
  telemetry = new TelemetryStore();
  telemetry.greet(START_S, 0);
  telemetry.setStaleAfter([["ahrs", 0.3]]);
});

describe("a value", () => {
  test("never heard is no data, and not zero", () => {
    expect(telemetry.state("ahrs", 10)).toBe("none");
    expect(telemetry.liveNumber("ahrs", "roll_deg", 10)).toBeNull();
    expect(telemetry.age_s("ahrs", 10)).toBeNull();
  });

  test("is live while it is young", () => {
    batch(1000);
    expect(telemetry.state("ahrs", 1200)).toBe("live");
    expect(telemetry.liveNumber("ahrs", "roll_deg", 1200)).toBe(30);
    expect(telemetry.age_s("ahrs", 1200)).toBeCloseTo(0.2, 6);
  });

  test("older than its stream allows is stale though the gateway is well", () => {
    batch(1000);
    telemetry.heard(1900);
    expect(telemetry.state("ahrs", 1900)).toBe("stale");
    expect(telemetry.liveNumber("ahrs", "roll_deg", 1900)).toBeNull();
    expect(telemetry.newestNumber("ahrs", "roll_deg")).toBe(30);
  });

  test("of a batch that was held up on the way is as old as it is", () => {
    batch(1000);
    // Made at 1.1 s, here at 6 s: a stalled browser gets its past in one go.
    telemetry.apply(START_S + 1.1, [{ topic: "ahrs", t_s: START_S + 1.1, values: { roll_deg: 31 } }], 6000);
    expect(telemetry.state("ahrs", 6000)).toBe("stale");
    expect(telemetry.age_s("ahrs", 6000)).toBeCloseTo(4.9, 1);
  });

  test("that the gateway kept for long is stale when it arrives first", () => {
    batch(1000, 8);
    expect(telemetry.state("ahrs", 1000)).toBe("stale");
  });

  test("of null stays null while its topic is live", () => {
    telemetry.apply(START_S + 1, [{ topic: "ahrs", t_s: START_S + 1, values: { roll_deg: null } }], 1000);
    expect(telemetry.state("ahrs", 1000)).toBe("live");
    expect(telemetry.liveNumber("ahrs", "roll_deg", 1000)).toBeNull();
  });
});

describe("the gateway", () => {
  test("silent for more than a second makes everything stale", () => {
    telemetry.setStaleAfter([["ahrs", 60]]);
    batch(1000);
    expect(telemetry.state("ahrs", 1000 + SILENCE_MS)).toBe("live");
    expect(telemetry.state("ahrs", 1001 + SILENCE_MS)).toBe("stale");
  });

  test("that hung up makes everything stale at once", () => {
    batch(1000);
    telemetry.silence();
    expect(telemetry.state("ahrs", 1001)).toBe("stale");
    expect(telemetry.isConnected(1001)).toBe(false);
  });

  test("that started again with another clock does not make new samples old", () => {
    batch(1000);
    telemetry.greet(START_S - 500, 2000);
    telemetry.apply(START_S - 500, [{ topic: "ahrs", t_s: START_S - 500, values: { roll_deg: 1 } }], 2000);
    expect(telemetry.state("ahrs", 2100)).toBe("live");
  });
});

test("a flag that was not sent is unknown, not off", () => {
  telemetry.apply(START_S, [{ topic: "heartbeat", t_s: START_S, values: { ahrs: true } }], 0);
  expect(telemetry.liveFlag("heartbeat", "ahrs", 0)).toBe(true);
  expect(telemetry.liveFlag("heartbeat", "gps", 0)).toBeNull();
});

test("the revision moves with every arrival, so that painters know", () => {
  const before = telemetry.revision;
  batch(10);
  expect(telemetry.revision).not.toBe(before);
});

describe("a row of the simulator", () => {
  const heard = (now_ms: number): void =>
    telemetry.applyRows({ t_s: START_S + now_ms / 1000, rows: [[17, [1.5, null]]] });

  test("is live while the gateway tells it, and then stale and without a value", () => {
    expect(telemetry.rowState(17, 0)).toBe("none");
    heard(0);
    expect(telemetry.liveRowValue(17, 0, 900)).toBe(1.5);
    expect(telemetry.liveRowValue(17, 1, 900)).toBeNull();
    telemetry.heard(1900);
    expect(telemetry.rowState(17, 1900)).toBe("stale");
    expect(telemetry.rowAge_s(17, 1900)).toBeCloseTo(1.9, 6);
    expect(telemetry.liveRowValue(17, 0, 1900)).toBeNull();
  });

  test("that others follow without it grows old by itself", () => {
    heard(0);
    telemetry.heard(1500);
    telemetry.applyRows({ t_s: START_S + 1.5, rows: [[3, [55]]] });
    expect(telemetry.rowState(17, 1500)).toBe("stale");
    expect(telemetry.rowState(3, 1500)).toBe("live");
  });
});

test("a field known only by its name is read like any other", () => {
  batch(1000);
  expect(telemetry.liveNumberOf("ahrs", "roll_deg", 1100)).toBe(30);
  expect(telemetry.liveNumberOf("ahrs", "no_such_field", 1100)).toBeNull();
  telemetry.heard(2000);
  expect(telemetry.liveNumberOf("ahrs", "roll_deg", 2000)).toBeNull();
});

test("an old flag is not live, and can still be read as what was heard last", () => {
  expect(telemetry.newestFlag("gps", "valid")).toBeNull();
  telemetry.apply(START_S, [{ topic: "gps", t_s: START_S, values: { valid: true } }], 0);
  telemetry.heard(1900);
  expect(telemetry.state("gps", 1900)).toBe("stale");
  expect(telemetry.liveFlag("gps", "valid", 1900)).toBeNull();
  expect(telemetry.newestFlag("gps", "valid")).toBe(true);
});

test("a stream may be as old as three of its periods and what the way takes, and not older", () => {
  telemetry.setStaleAfter([["ahrs", 0.5]]);
  batch(1000);
  telemetry.heard(1700);
  expect(telemetry.state("ahrs", 1649)).toBe("live");
  expect(telemetry.state("ahrs", 1651)).toBe("stale");
});

test("before its limit is known a stream is live for a second and what the way takes", () => {
  telemetry.setStaleAfter([["ahrs", null]]);
  batch(1000);
  telemetry.heard(2100);
  expect(telemetry.state("ahrs", 2149)).toBe("live");
  expect(telemetry.state("ahrs", 2151)).toBe("stale");
});

test("without the gateway's clock nothing has an age, and nothing is live", () => {
  const unmet = new TelemetryStore();
  unmet.applyRows({ t_s: START_S, rows: [[17, [1]]] });
  expect(unmet.rowAge_s(17, 0)).toBeNull();
  expect(unmet.liveRowValue(17, 0, 0)).toBeNull();
});

test("the time of the newest sample is the gateway's, and there is none before one was heard", () => {
  expect(telemetry.newestAt_s("ahrs")).toBeNull();
  expect(telemetry.newestNumberOf("ahrs", "roll_deg")).toBeNull();
  batch(1000, 0.25);
  expect(telemetry.newestAt_s("ahrs")).toBe(START_S + 0.75);
});

test("every row that was heard can be listed, a live one without such a value has none", () => {
  telemetry.applyRows({ t_s: START_S, rows: [[17, [1.5]]] });
  expect([...telemetry.rows.keys()]).toEqual([17]);
  expect(telemetry.liveRowValue(17, 7, 0)).toBeNull();
  expect(telemetry.liveRowValue(3, 0, 0)).toBeNull();
});

test("a row is live until a second and what the way takes have passed", () => {
  telemetry.applyRows({ t_s: START_S, rows: [[17, [1.5]]] });
  telemetry.heard(1100);
  expect(telemetry.rowState(17, 1149)).toBe("live");
  expect(telemetry.rowState(17, 1151)).toBe("stale");
});

test("a connection that is lost moves the revision, too: what is on the screen must be painted stale", () => {
  const before = telemetry.revision;
  telemetry.silence();
  expect(telemetry.revision).toBeGreaterThan(before);
});

test("what a paused simulator says is not live, however new, and what the board says is", () => {
  batch(1000);
  telemetry.apply(START_S + 1, [{ topic: "simulator", t_s: START_S + 1, values: { pitch_deg: 5 } }], 1000);
  telemetry.applyRows({ t_s: START_S + 1, rows: [[17, [5]]] });
  telemetry.setPaused(true);
  expect(telemetry.state("simulator", 1001)).toBe("stale");
  expect(telemetry.liveNumber("simulator", "pitch_deg", 1001)).toBeNull();
  expect(telemetry.rowState(17, 1001)).toBe("stale");
  expect(telemetry.state("ahrs", 1001)).toBe("live");
  telemetry.setPaused(false);
  expect(telemetry.state("simulator", 1001)).toBe("live");
  expect(telemetry.rowState(17, 1001)).toBe("live");
});
