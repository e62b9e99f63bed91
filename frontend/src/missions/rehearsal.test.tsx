import { expect, test } from "vitest";
import { choose } from "../store/settings";
import { Station } from "../test/station";
import { conditionsNow, type FlightConditions } from "./rehearsal";
import { WIND_CHOICES } from "./useWind";

const FLYING = {
  gps: {
    latitude_deg: 27.9,
    longitude_deg: -15.4,
    altitude_m: 304.8,
    heading_deg: 90,
    speed_kt: 75,
    fix: 3,
    valid: true,
  },
  ahrs: { yaw_deg: 90, roll_deg: 1 },
  analog: { calibrated_airspeed_kt: 55 },
  simulator: {
    latitude_deg: 28.1,
    longitude_deg: -15.5,
    altitude_msl_ft: 1500,
    horizontal_path_deg: 200,
    indicated_airspeed_kt: 60,
  },
};

function conditions(station: Station, plan: "flight" | "hil"): FlightConditions {
  const { telemetry, settings, pump } = station.page;
  return conditionsNow(telemetry, settings.getState(), plan, pump.now_ms);
}

function flying(): Station {
  const station = new Station(<p />);
  station.greet();
  station.send(FLYING);
  return station;
}

test("each plan begins where its own aircraft is", () => {
  const station = flying();
  expect(conditions(station, "flight").start).toMatchObject({
    latitude_deg: 27.9,
    altitude_ft: 1000,
    track_deg: 90,
    speed_kt: 55,
  });
  expect(conditions(station, "hil").start).toEqual({
    latitude_deg: 28.1,
    longitude_deg: -15.5,
    altitude_ft: 1500,
    track_deg: 200,
    speed_kt: 60,
  });
});

test("a receiver without a fix has no place", () => {
  const station = flying();
  station.send({ gps: { ...FLYING.gps, fix: 0 } });
  expect(conditions(station, "flight").start).toBeNull();
});

test("the wind is the one that was entered, else the real aircraft's while it is live, else none", () => {
  const station = flying();
  expect(conditions(station, "flight")).toMatchObject({ windSource: "aircraft", wind: { from_deg: 270 } });
  expect(conditions(station, "hil").windSource).toBe("none");
  choose(station.page.settings, WIND_CHOICES.speed, "0");
  expect(conditions(station, "flight")).toMatchObject({ windSource: "entered", wind: { speed_kt: 0 } });
});

test("what is not live any more is neither place nor wind", () => {
  const station = flying();
  station.pass(60_000);
  expect(conditions(station, "flight")).toMatchObject({ start: null, windSource: "none" });
});
