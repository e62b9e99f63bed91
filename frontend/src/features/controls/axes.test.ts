import { beforeEach, describe, expect, test } from "vitest";
import { TelemetryStore } from "../../store/telemetry";
import { axisNumber, axisState, readAutopilot, readAutotrim } from "./axes";

const START_S = 1_700_000_000;
let telemetry: TelemetryStore;

function hear(topic: string, values: Readonly<Record<string, number | boolean>>, at_ms: number): void {
  const t_s = START_S + at_ms / 1000;
  telemetry.apply(t_s, [{ topic, t_s, values }], at_ms);
}

const flags = { autopilot: true, autotrim: false, autopilot_hil: false, autotrim_hil: true };

beforeEach(() => {
  telemetry = new TelemetryStore();
  telemetry.greet(START_S, 0);
  hear("xplane_info", { elevator: 0.1, aileron: 0.2, rudder: 0.3, throttle: 0.4 }, 0);
  hear("servos_in", { channel_0: -0.2, channel_1: -0.1, channel_2: 0.9, channel_3: -0.3 }, 0);
});

describe("with the joystick as source", () => {
  beforeEach(() => hear("heartbeat", { ...flags, source_joystick: true }, 0));

  test("the controls are the stick's and the flags those of the HIL", () => {
    expect(axisNumber(telemetry, "elevator")).toBe(0.1);
    expect(axisNumber(telemetry, "throttle")).toBe(0.4);
    expect([readAutopilot(telemetry), readAutotrim(telemetry)]).toEqual([false, true]);
  });

  test("a stick that is not heard any more is stale whatever the RC says", () => {
    hear("servos_in", { channel_0: 0 }, 1400);
    hear("heartbeat", { ...flags, source_joystick: true }, 1400);
    expect(axisState(telemetry, 1400, "simulator")).toBe("stale");
  });
});

describe("with a gamepad as the stick", () => {
  beforeEach(() => hear("heartbeat", { ...flags, source_joystick: true }, 0));

  test("the controls are what the board is told, and none at all while nothing arrives from the gamepad", () => {
    expect(axisState(telemetry, 100, "gamepad")).toBe("live");
    expect(axisState(telemetry, 100, "lost")).toBe("none");
  });

  test("the RC's channels are live all the same", () => {
    hear("heartbeat", { ...flags, source_joystick: false }, 50);
    expect(axisState(telemetry, 100, "lost")).toBe("live");
  });
});

describe("with RC as source", () => {
  beforeEach(() => hear("heartbeat", { ...flags, source_joystick: false }, 0));

  test("the controls are channels 0, 1, 3 and 2, and the flags those of the transmitter", () => {
    expect(
      (["aileron", "elevator", "rudder", "throttle"] as const).map((axis) => axisNumber(telemetry, axis)),
    ).toEqual([-0.2, -0.1, -0.3, 0.9]);
    expect([readAutopilot(telemetry), readAutotrim(telemetry)]).toEqual([true, false]);
  });
});

test("without a live heartbeat no source is known, so no control counts as live", () => {
  hear("heartbeat", { ...flags, source_joystick: true }, 0);
  expect(axisState(telemetry, 100, "simulator")).toBe("live");
  hear("xplane_info", { elevator: 0.1 }, 1400);
  expect(axisState(telemetry, 1400, "simulator")).toBe("stale");
});

test("nothing heard of the source is no data", () => {
  expect(axisState(new TelemetryStore(), 0, "simulator")).toBe("none");
});
