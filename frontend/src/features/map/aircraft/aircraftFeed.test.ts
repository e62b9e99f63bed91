import { beforeEach, describe, expect, test } from "vitest";
import { FlightClock } from "../../../store/clock";
import { TelemetryStore } from "../../../store/telemetry";
import { AircraftMotion, showing } from "./aircraftFeed";
import { flatAircraft } from "./flatAircraft";

const START_S = 1_700_000_000;
const NAMES = { flight: "Real", hil: "Simulado" };
const GPS = { latitude_deg: 28, longitude_deg: -15.4, altitude_m: 500, valid: true };
const AHRS = { yaw_deg: 90, pitch_deg: 5, roll_deg: 10 };
const SIMULATOR = {
  latitude_deg: 28.1,
  longitude_deg: -15.5,
  altitude_msl_ft: 1000,
  true_heading_deg: 180,
  pitch_deg: 1,
  roll_deg: 2,
};
let telemetry: TelemetryStore;

function sample(
  topic: string,
  now_ms: number,
  values: Readonly<Record<string, number | boolean | null>>,
): void {
  const t_s = START_S + now_ms / 1000;
  telemetry.apply(t_s, [{ topic, t_s, values }], now_ms);
}

beforeEach(() => {
  telemetry = new TelemetryStore();
  telemetry.greet(START_S, 0);
  telemetry.setStaleAfter(["gps", "ahrs", "simulator"].map((topic) => [topic, 0.3]));
});

describe("an aircraft on the map", () => {
  test("is not there before anything of it was heard", () => {
    expect(showing(telemetry, "flight", 0)).toBe("notHeard");
    expect(new AircraftMotion().seen(telemetry, NAMES, 0)).toEqual({ flight: null, hil: null });
    expect(flatAircraft(telemetry, "flight", "Real", 0)).toBeNull();
  });

  test("is not there while its receiver says that the position is not valid", () => {
    sample("gps", 100, { ...GPS, valid: false });
    sample("ahrs", 100, AHRS);
    expect(showing(telemetry, "flight", 100)).toBe("noPosition");
    expect(flatAircraft(telemetry, "flight", "Real", 100)).toBeNull();
    const motion = new AircraftMotion();
    motion.take(telemetry, 100);
    expect(motion.seen(telemetry, NAMES, 100).flight).toBeNull();
  });

  test("without an attitude has a place, and is not called live", () => {
    sample("gps", 100, GPS);
    expect(showing(telemetry, "flight", 100)).toBe("noAttitude");
    const motion = new AircraftMotion();
    motion.take(telemetry, 100);
    expect(motion.seen(telemetry, NAMES, 100).flight).toMatchObject({
      place: { latitude_deg: 28, longitude_deg: -15.4, altitude_m: 500 },
      attitude: null,
      isLive: false,
    });
    expect(flatAircraft(telemetry, "flight", "Real", 100)).toMatchObject({
      heading_deg: null,
      label: "Real",
    });
  });

  test("that is heard stands where it is, by its name, with heights of the simulator in metres", () => {
    sample("simulator", 100, SIMULATOR);
    const motion = new AircraftMotion();
    motion.take(telemetry, 100);
    const { hil } = motion.seen(telemetry, NAMES, 100);
    expect(hil).toMatchObject({ isLive: true, label: "Simulado" });
    expect(hil?.place.altitude_m).toBeCloseTo(304.8);
    expect(hil?.attitude?.yaw_deg).toBeCloseTo(180);
    expect(flatAircraft(telemetry, "hil", "Simulado", 100)).toMatchObject({
      heading_deg: 180,
      isLive: true,
      label: "Simulado",
    });
  });

  test("that is heard no more says how old it is and does not look live, on either map", () => {
    sample("gps", 100, GPS);
    sample("ahrs", 100, AHRS);
    const motion = new AircraftMotion();
    motion.take(telemetry, 100);
    telemetry.heard(2100);
    expect(showing(telemetry, "flight", 2100)).toBe("stale");
    const globe = motion.seen(telemetry, NAMES, 2100).flight;
    const flat = flatAircraft(telemetry, "flight", "Real", 2100);
    expect([globe?.isLive, flat?.isLive]).toEqual([false, false]);
    expect(globe?.label).toMatch(/^Real · .*2/);
    expect(flat?.label).toBe(globe?.label);
  });

  test("is as old as the older of place and attitude", () => {
    sample("ahrs", 100, AHRS);
    sample("gps", 3100, GPS);
    expect(showing(telemetry, "flight", 3100)).toBe("stale");
    expect(flatAircraft(telemetry, "flight", "Real", 3100)).toMatchObject({ isLive: false });
  });
});

describe("the motion of an aircraft", () => {
  test("goes between two samples, and never ahead of the newest", () => {
    const motion = new AircraftMotion();
    for (const [now_ms, latitude_deg] of [
      [0, 28],
      [100, 28.001],
      [200, 28.002],
    ] as const) {
      sample("gps", now_ms, { ...GPS, latitude_deg });
      sample("ahrs", now_ms, AHRS);
      motion.take(telemetry, now_ms);
    }
    const between = motion.seen(telemetry, NAMES, 250).flight?.place.latitude_deg ?? 0;
    expect(between).toBeGreaterThan(28.001);
    expect(between).toBeLessThan(28.002);
    expect(motion.seen(telemetry, NAMES, 900).flight?.place.latitude_deg).toBe(28.002);
  });

  test("does not fly from where it was to where a seek in the past has put it", () => {
    telemetry = new TelemetryStore(new FlightClock());
    telemetry.greet(START_S, 0);
    const motion = new AircraftMotion();
    const at = (t_s: number, latitude_deg: number): void => {
      telemetry.apply(
        t_s,
        [
          { topic: "gps", t_s, values: { ...GPS, latitude_deg } },
          { topic: "ahrs", t_s, values: AHRS },
        ],
        100,
      );
      motion.take(telemetry, 100);
    };
    at(START_S + 10, 28);
    at(START_S + 10.1, 28.001);
    const { jumps } = telemetry;
    at(START_S + 9, 27);
    expect(telemetry.jumps).toBeGreaterThan(jumps);
    expect(motion.seen(telemetry, NAMES, 100).flight?.place.latitude_deg).toBe(27);
  });
});
