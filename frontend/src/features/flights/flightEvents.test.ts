import { describe, expect, test } from "vitest";
import { aFlightEvent } from "../../test/flights";
import { eventMessage, groupOf } from "./flightEvents";

type Sentence = { readonly key: string; readonly params: unknown };

function said(parts: Parameters<typeof aFlightEvent>[0]): Sentence {
  const { key, params } = eventMessage(aFlightEvent(parts));
  return { key, params };
}

function fallback(parts: Parameters<typeof aFlightEvent>[0]): unknown {
  return eventMessage(aFlightEvent(parts)).fallback;
}

describe("a command of the flight", () => {
  test("that the board refused is said with its reason", () => {
    const refused = said({
      kind: "command",
      name: "autopilot_on",
      data: { state: "rejected", by: null, ms: null, reason: "busy" },
    });
    expect(refused.key).not.toBe("flightEvent.pending");
    expect(JSON.stringify(refused.params)).toContain("autopilot_on");
  });

  test("whose answer the recording does not have is said so, and never as done", () => {
    for (const state of [undefined, "underway", 3]) {
      expect(said({ kind: "command", name: "autopilot_on", data: { state } })).toEqual({
        key: "flightEvent.pending",
        params: { what: "@command.autopilot_on" },
      });
    }
  });
});

describe("an event", () => {
  test("of a mode says whether it came or went", () => {
    const params = { mode: "@flightMode.autopilot" };
    expect(said({ kind: "mode", name: "autopilot", data: { on: true } })).toEqual({
      key: "flightEvent.modeOn",
      params,
    });
    expect(said({ kind: "mode", name: "autopilot", data: { on: false } })).toEqual({
      key: "flightEvent.modeOff",
      params,
    });
  });

  test("of advice is said in the page's words, with its level and values", () => {
    const event = aFlightEvent({
      kind: "advice",
      name: "line_full",
      data: { code: "line_full", level: "warning", text: "full", params: { percent: 93, direction: "rx" } },
    });
    expect(eventMessage(event)).toEqual({
      level: "warning",
      key: "advice.line_full",
      params: { percent: 93, direction: "@direction.rx" },
      fallback: "full",
    });
    expect(groupOf(event)).toBe("advice");
    expect(fallback({ kind: "advice", name: "of_tomorrow", data: {} })).toBe("of_tomorrow");
  });

  test("of a waypoint says from where to where", () => {
    expect(said({ kind: "waypoint", name: "hil", data: { from: 1, to: 2 } })).toEqual({
      key: "flightEvent.waypoint",
      params: { plan: "@flightPlan.hil", from: 1, to: 2 },
    });
  });

  test("of a plan, the console and control is said with what it is about", () => {
    expect(said({ kind: "plan", name: "flight" }).params).toEqual({ plan: "@flightPlan.flight" });
    expect(said({ kind: "console", data: { line: "ver" } }).params).toEqual({ text: "ver" });
    expect(said({ kind: "control", name: "Ana" })).toEqual({
      key: "flightEvent.control",
      params: { name: "Ana" },
    });
    expect(said({ kind: "control", name: "" }).key).toBe("flightEvent.nobody");
  });

  test("of gains names each that changed", () => {
    const several = { parameters: { roll_kp: { value: 1 }, roll_ki: { value: null } } };
    expect(said({ kind: "parameter", data: several }).params).toEqual({ names: "roll_kp, roll_ki" });
    expect(said({ kind: "parameter" }).params).toEqual({ names: "?" });
  });

  test("says who moves the simulator's surfaces, and with what stick", () => {
    expect(said({ kind: "mode", name: "assisted", data: { on: true } }).key).toBe("flightEvent.assisted");
    expect(said({ kind: "mode", name: "assisted", data: { on: false } }).key).toBe("flightEvent.manual");
    const gamepad = { gamepad: "Xbox", state: "live" };
    expect(said({ kind: "stick", name: "gamepad", data: gamepad })).toEqual({
      key: "flightEvent.stickGamepad",
      params: { gamepad: "Xbox" },
    });
    expect(said({ kind: "stick", name: "gamepad", data: { ...gamepad, state: "lost" } }).key).toBe(
      "flightEvent.stickLost",
    );
    expect(said({ kind: "stick", name: "simulator" }).key).toBe("flightEvent.stickSimulator");
  });

  test("of a fault in the simulator says where it is, what it does, and whether it ended; of wind what blows", () => {
    const words = { place: "@faultPlace.gps", kind: "@faultKind.drift" };
    const fault = { kind: "fault", name: "gps" } as const;
    expect(said({ ...fault, data: { kind: "drift", state: "begun" } })).toEqual({
      key: "flightEvent.faultBegun",
      params: words,
    });
    expect(said({ ...fault, data: { kind: "drift", state: "ended" } })).toEqual({
      key: "flightEvent.faultEnded",
      params: words,
    });
    expect(groupOf({ kind: "fault" })).toBe("trouble");
    const wind = { from_deg: 250, speed_kt: 15, turbulence: "light" };
    expect(said({ kind: "wind", data: wind }).params).toEqual({ ...wind, turbulence: "@turbulence.light" });
  });

  test("of a limit says its value before and after, and of a silence whose it is", () => {
    expect(said({ kind: "limits", name: "battery_low_v", data: { before: 10, after: 11.5 } }).params).toEqual(
      {
        name: "@alarmThreshold.battery_low_v",
        before: 10,
        after: 11.5,
      },
    );
    expect(said({ kind: "gap", name: "simulator" }).key).toBe("flightEvent.simulatorGap");
    expect(said({ kind: "gap", name: "silence" }).key).toBe("flightEvent.gap");
  });

  test("of the lines says the state of both, also where one is not known", () => {
    expect(said({ kind: "link", data: { board: "open" } })).toEqual({
      key: "flightEvent.lines",
      params: { board: "@link.open", simulator: "@link.unknown" },
    });
  });

  test("of lost bytes says how many and why", () => {
    expect(said({ kind: "lost", name: "disk", data: { bytes: 400 } })).toEqual({
      key: "flightEvent.lost",
      params: { bytes: 400, reason: "disk" },
    });
  });

  test("that this page does not know is shown by its own name", () => {
    expect(fallback({ kind: "restart", name: "watchdog" })).toBe("restart watchdog");
    expect(fallback({ kind: "link", name: "flapping" })).toBe("flapping");
    expect(fallback({ kind: "alarm", name: "icing" })).toBe("icing");
    expect(fallback({ kind: "alarm", name: "icing", data: { text: "Ice.", params: 3 } })).toBe("Ice.");
  });
});

test("what belongs to no other group is trouble, so that it is never hidden with the harmless", () => {
  expect(groupOf({ kind: "parameter" })).toBe("command");
  expect(groupOf({ kind: "control" })).toBe("mode");
  for (const kind of ["gap", "damage", "lost", "restart", "link"] as const) {
    expect(groupOf({ kind })).toBe("trouble");
  }
});

test("the station's own computer is named in the page's language", () => {
  expect(said({ kind: "control", name: "this computer" }).params).toEqual({ name: "@control.station" });
  expect(said({ kind: "control", name: "Ana · tableta" }).params).toEqual({ name: "Ana · tableta" });
});
