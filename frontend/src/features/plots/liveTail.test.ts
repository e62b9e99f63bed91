import { beforeEach, describe, expect, test } from "vitest";
import { TelemetryStore } from "../../store/telemetry";
import { drawnOf, type PlotSeries } from "./drawn";
import { LiveTail } from "./liveTail";

const START_S = 1_700_000_000;
let telemetry: TelemetryStore;
let tail: LiveTail;

/** The gateway's answer: steps every 0.1 s until a second of the flight. */
function answered(name: string, unit = "deg"): PlotSeries {
  const at_s = Array.from({ length: 11 }, (_, index) => index / 10);
  const values = at_s.map(() => 1);
  return drawnOf({ name, unit, at_s, min: values, max: values, mean: 1, count: 11 });
}

/** A sample as it comes over the stream, seconds since the flight's start. */
function sample(
  topic: string,
  at_s: number,
  values: Readonly<Record<string, number | boolean | null>>,
): void {
  const t_s = START_S + at_s;
  telemetry.apply(t_s, [{ topic, t_s, values }], at_s * 1000);
  tail.take(telemetry);
}

function extended(name: string, unit?: string): ReadonlyArray<readonly [number, number | null]> {
  const { at_s, low } = tail.extend(answered(name, unit), START_S, 1);
  return at_s.slice(11).map((time_s, index) => [Number(time_s.toFixed(3)), low[index + 11] ?? null]);
}

beforeEach(() => {
  telemetry = new TelemetryStore();
  telemetry.greet(START_S, 0);
  tail = new LiveTail();
});

describe("the newest samples of a plot", () => {
  beforeEach(() => tail.follow(["ahrs.roll_deg"]));

  test("go on where the gateway's answer ends, in the unit that is shown", () => {
    tail.follow(["inertial.gx_rad_s"]);
    sample("inertial", 0.9, { gx_rad_s: 5 });
    sample("inertial", 1.1, { gx_rad_s: Math.PI });
    const [[at_s, shown] = []] = extended("inertial.gx_rad_s", "rad/s");
    expect(at_s).toBe(1.1);
    expect(shown).toBeCloseTo(180);
  });

  test("leave the answer as it is while there are none", () => {
    const drawn = answered("ahrs.roll_deg");
    expect(tail.extend(drawn, START_S, 1)).toBe(drawn);
  });

  test("are each taken once", () => {
    sample("ahrs", 1.1, { roll_deg: 2 });
    const { revision } = tail;
    tail.take(telemetry);
    expect(tail.revision).toBe(revision);
    expect(extended("ahrs.roll_deg")).toEqual([[1.1, 2]]);
  });

  test("are not joined over a silence: the gap stays a gap", () => {
    sample("ahrs", 3, { roll_deg: 2 });
    expect(extended("ahrs.roll_deg")).toEqual([
      [2, null],
      [3, 2],
    ]);
  });

  test("without a value are a gap, and a flag is drawn as nought and one", () => {
    sample("ahrs", 1.1, { roll_deg: null });
    expect(extended("ahrs.roll_deg")).toEqual([[1.1, null]]);
    tail.follow(["heartbeat.source_joystick"]);
    sample("heartbeat", 1.1, { source_joystick: true });
    sample("heartbeat", 1.2, { source_joystick: false });
    expect(extended("heartbeat.source_joystick", "1").map(([, value]) => value)).toEqual([1, 0]);
  });

  test("are forgotten with the vehicle, and those of a signal that nobody shows any more", () => {
    sample("ahrs", 1.1, { roll_deg: 2 });
    tail.clear();
    expect(extended("ahrs.roll_deg")).toEqual([]);
    sample("ahrs", 1.2, { roll_deg: 3 });
    tail.follow(["ahrs.pitch_deg"]);
    tail.follow(["ahrs.roll_deg"]);
    expect(extended("ahrs.roll_deg")).toEqual([]);
  });

  test("are kept for a minute and not for the whole flight", () => {
    for (let count = 0; count < 1000; count += 1) {
      sample("ahrs", 1 + count / 10, { roll_deg: count });
    }
    const kept = extended("ahrs.roll_deg").filter(([, value]) => value !== null);
    expect(kept.at(-1)?.[1]).toBe(999);
    expect(kept.length).toBeLessThan(720);
    expect(kept.length).toBeGreaterThan(600);
  });

  test("of what is no signal of the stream are none", () => {
    tail.follow(["clouds.cover"]);
    sample("ahrs", 1.1, { roll_deg: 2 });
    expect(extended("clouds.cover")).toEqual([]);
  });
});

describe("a computed signal", () => {
  test("of a difference has the other's newest value of that moment, the short way round", () => {
    tail.follow(["ahrs.yaw_deg", "gps.heading_deg"]);
    sample("ahrs", 1.05, { yaw_deg: 10 });
    sample("gps", 1.1, { heading_deg: 350 });
    sample("ahrs", 1.2, { yaw_deg: 5 });
    expect(extended("diff(ahrs.yaw_deg,gps.heading_deg)")).toEqual([
      [1.05, null],
      [1.2, 15],
    ]);
    expect(extended("error(ahrs.yaw_deg,gps.heading_deg)").at(-1)).toEqual([1.2, -15]);
  });

  test("of a rate is the change in each second, and none over a gap or across north the long way", () => {
    tail.follow(["ahrs.yaw_deg"]);
    for (const [at_s, yaw_deg] of [
      [1.1, 358],
      [1.2, 359],
      [1.3, 1],
      [4, 50],
    ] as const) {
      sample("ahrs", at_s, { yaw_deg });
    }
    const rates = extended("rate(ahrs.yaw_deg)").map(([, value]) => value && Math.round(value));
    expect(rates).toEqual([null, 10, 20, null, null]);
  });

  test("of two units waits for the gateway, which converts them", () => {
    tail.follow(["analog.altitude_m", "simulator.altitude_msl_ft"]);
    sample("analog", 1.1, { altitude_m: 100 });
    sample("simulator", 1.2, { altitude_msl_ft: 300 });
    expect(extended("diff(analog.altitude_m,simulator.altitude_msl_ft)")).toEqual([]);
  });
});
