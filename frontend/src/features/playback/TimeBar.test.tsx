import { act, fireEvent, screen, within } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { beforeEach, describe, expect, test } from "vitest";
import { aStatus } from "../../test/aStatus";
import { FLIGHT, FLIGHT_STARTS_S } from "../../test/replay";
import { type FakeRequest, Station } from "../../test/station";
import { PLAYBACK } from "./playbackRequests";

/** Answers what the page asks about flights and has not been answered yet. */
async function answerFlights(station: Station, edge_s = 600): Promise<void> {
  const open = station.askedByBar.filter(({ path }) => !answered.has(path + edge_s));
  for (const asked of open) {
    answered.add(asked.path + edge_s);
    await answerOne(asked, edge_s);
  }
}

const answered = new Set<string>();

function answerOne({ path, answer }: FakeRequest, edge_s: number): Promise<void> {
  if (path.includes("/overview")) {
    return answer({
      duration_s: edge_s,
      signal: "gps.altitude_m",
      altitude_ft: [0, 500, 900],
      gaps: [[100, 120]],
    });
  }
  if (path.includes("/events")) {
    return answer({
      events: [
        anEvent(60, "command", "autopilot_on"),
        anEvent(200, "alarm", "battery_low", { until: 30, level: "warning", text: "Low battery." }),
        anEvent(400, "mark", "stall"),
      ],
    });
  }
  return answer({ code: "flight_unknown", detail: "No such flight.", params: {} }, 404);
}

function anEvent(at_s: number, kind: string, name: string, data: Readonly<Record<string, unknown>> = {}) {
  const { until, ...rest } = data;
  const t_s = FLIGHT_STARTS_S + at_s;
  return {
    at_s,
    t_s,
    kind,
    name,
    id: null,
    data: rest,
    until_s: typeof until === "number" ? t_s + until : null,
  };
}

function slider(): HTMLElement {
  return screen.getByRole("slider", { name: "Momento del vuelo" });
}

function press(key: string, more: Partial<KeyboardEventInit> = {}, target: Element = document.body): void {
  act(() => {
    fireEvent.keyDown(target, { key, ...more });
  });
}

const AHRS = { yaw_deg: 10, pitch_deg: 5, roll_deg: 20 };

/** A live flight with a roll of 20 degrees, and the past open at 100 s of it. */
function inThePast(): Station {
  const station = new Station();
  station.greet();
  station.send({ ahrs: AHRS, heartbeat: { source_joystick: true } });
  act(() => station.page.parts.get(PLAYBACK).openFlight("current", 100));
  station.replayed((replay) => replay.greet());
  return station;
}

const NOT_RECORDING = {
  active: false,
  failure: null,
  file: null,
  bytes: 0,
  bytes_lost: 0,
  free_bytes: null,
  hours_left: null,
};

beforeEach(() => answered.clear());

describe("the present", () => {
  test("has a thin bar of the flight so far, with now at its right edge", async () => {
    const station = new Station();
    station.greet();
    await answerFlights(station);
    expect(slider().getAttribute("aria-valuetext")).toBe("Ahora, 10:00 de vuelo");
    expect(screen.queryByRole("toolbar", { name: "Mandos de la reproducción" })).toBeNull();
  });

  test("says why there is nothing to look back at while nothing is recorded, and asks about nothing", () => {
    const station = new Station();
    station.greet(aStatus({ recording: NOT_RECORDING }));
    const none = "Sin grabación en marcha: no hay nada que mirar atrás.";
    expect(screen.getByText(none)).toBeTruthy();
    expect(screen.queryByRole("slider", { name: "Momento del vuelo" })).toBeNull();
    act(() => station.page.parts.get(PLAYBACK).openFlight(FLIGHT, 100));
    press("Escape");
    expect(screen.getByText(none)).toBeTruthy();
    expect(station.askedByBar.filter(({ path }) => path.includes("current"))).toEqual([]);
  });

  test("is left by the arrow keys on the bar, ten seconds with Ctrl", async () => {
    const station = new Station();
    station.greet();
    await answerFlights(station);
    press("ArrowLeft", { ctrlKey: true }, slider());
    expect(station.replay.place).toEqual({ flight: "current", at_s: 590 });
  });
});

describe("the past", () => {
  test("is said in words, in the window's title and with the time of the flight", () => {
    inThePast();
    expect(screen.getByText("PASADO")).toBeTruthy();
    const clock = new Date((FLIGHT_STARTS_S + 100) * 1000).toTimeString().slice(0, 8);
    expect(document.title).toContain("PASADO");
    expect(document.title).toContain(clock);
    expect(document.querySelector('.app[data-past="true"]')).toBeTruthy();
  });

  test("says what each of its rows of marks is, in their order; the present has none", () => {
    inThePast();
    const rows = [...slider().querySelectorAll("[data-lane]")].map((row) => row.textContent);
    expect(rows).toEqual(["Órdenes", "Modos", "Alarmas", "Waypoints", "Marcas"]);
    press("Escape");
    expect(document.querySelector("[data-lane]"), "the present has none").toBeNull();
  });

  test("shows nothing of the present: a value that its stream has not brought is no data", () => {
    const station = inThePast();
    const panel = screen.getByRole("complementary");
    expect(within(panel).queryByText("+20.0")).toBeNull();
    station.replayed((replay) => replay.send({ ahrs: { ...AHRS, roll_deg: -33 } }));
    expect(panel.textContent).toContain("33.0");
    station.send({ ahrs: { ...AHRS, roll_deg: 44 } });
    expect(panel.textContent).toContain("33.0");
    expect(panel.textContent).not.toContain("44.0");
  });

  test("shows nothing of a later moment after going back", () => {
    const station = inThePast();
    station.replayed((replay) => replay.send({ ahrs: AHRS, gps: { altitude_m: 300 } }));
    expect(station.replay).toBeTruthy();
    station.replayed((replay) => {
      replay.position({ at_s: 50 });
      replay.send({ ahrs: { ...AHRS, roll_deg: -5 } });
    });
    const { telemetry } = station.shown();
    expect(telemetry.newestNumber("ahrs", "roll_deg")).toBe(-5);
    expect(telemetry.newestNumber("gps", "altitude_m")).toBeNull();
  });

  test("keeps the age that a value had then, however long one looks", () => {
    const station = inThePast();
    station.replayed((replay) => replay.send({ ahrs: AHRS }));
    for (let count = 0; count < 10; count += 1) {
      station.pass(500);
      station.replayed((replay) => replay.position({}));
    }
    const { telemetry } = station.shown();
    expect(telemetry.state("ahrs", station.timers.now_ms())).toBe("live");
    expect(telemetry.age_s("ahrs", station.timers.now_ms())).toBe(0);
  });

  test("is left by Esc and by the button: the newest of the present is there at once", () => {
    const station = inThePast();
    station.replayed((replay) => replay.send({ ahrs: { ...AHRS, roll_deg: -33 } }));
    station.send({ ahrs: { ...AHRS, roll_deg: 44 } });
    press("Escape");
    expect(station.replay.wire.closed).toBe(true);
    station.show();
    const panel = screen.getByRole("complementary");
    expect(panel.textContent).toContain("44.0");
    expect(panel.textContent).not.toContain("33.0");
    expect(screen.queryByText("PASADO")).toBeNull();
    expect(document.title).not.toContain("PASADO");
  });

  test("has the present in a strip: its heartbeat, its attitude, and the way back", () => {
    const station = inThePast();
    station.send({ analog: { altitude_m: 152.4 } });
    const strip = screen.getByRole("region", { name: "El presente" });
    expect(strip.textContent).toContain("500ft");
    fireEvent.click(within(strip).getByRole("button", { name: "Volver a ahora" }));
    expect(screen.queryByRole("region", { name: "El presente" })).toBeNull();
  });

  test("does not hide an alarm of the present, and its tone sounds", () => {
    const station = inThePast();
    station.sounder.become("ready");
    const alarm = {
      id: "battery_low",
      level: "critical",
      since_s: 1,
      acknowledged: false,
      count: 1,
      text: "Low",
      params: {},
      until_s: null,
    } as const;
    station.status(aStatus({ alarms: [alarm] }));
    station.pass(300);
    expect(station.sounder.played.length).toBeGreaterThan(0);
    const acknowledge = screen.getByRole("button", { name: /^Reconocer: / });
    expect(acknowledge.getAttribute("aria-disabled")).toBeNull();
    fireEvent.click(acknowledge);
    expect(station.asked.filter(({ method }) => method === "POST").map(({ path }) => path)).toEqual([
      "/api/v1/alarms/battery_low/acknowledge",
    ]);
  });

  test("says that the stick in the hand goes on flying the present", () => {
    const station = inThePast();
    const stick = {
      source: "gamepad",
      state: null,
      client: "c1",
      name: "me",
      gamepad: "Pad",
      samples: {},
    } as const;
    station.status(aStatus({ hil: { source: "joystick", path: "manual", stick } }));
    expect(screen.getByText("Tu palanca sigue volando ahora.")).toBeTruthy();
  });
});

describe("in the past nothing is commanded", () => {
  test("by the person in control, by any key", () => {
    const station = inThePast();
    for (const key of ["a", "A", "t", "j", "m", "o", "l", "c"]) {
      press(key);
      press("Enter");
    }
    expect(station.asked.filter(({ method }) => method !== "GET")).toEqual([]);
    expect(screen.getByText(/Estás viendo el pasado/, { selector: ".ui-message *" })).toBeTruthy();
  });

  test("by any button or switch of the page", () => {
    const station = inThePast();
    station.replayed((replay) => replay.send({ heartbeat: { source_joystick: true } }));
    const controls = document.querySelectorAll<HTMLElement>(
      '.app-top button, .app-dock button, .app-dock input, .app-middle button, .app-middle input[type="range"]',
    );
    expect(controls.length).toBeGreaterThan(20);
    for (const control of controls) {
      if (control.closest(".present") === null) {
        fireEvent.click(control);
      }
    }
    expect(station.asked.filter(({ method }) => method !== "GET")).toEqual([]);
  });

  test("by a part of the present that asks late", async () => {
    const station = inThePast();
    const { ACTIONS } = await import("../../requests/actions");
    await act(() => station.page.parts.get(ACTIONS).command("autopilot_off", { control: "autopilot" }));
    expect(station.asked.filter(({ method }) => method !== "GET")).toEqual([]);
    press("Escape");
    void station.page.parts.get(ACTIONS).command("autopilot_off", { control: "autopilot" });
    expect(station.asked.filter(({ method }) => method !== "GET")).toHaveLength(1);
  });

  test("and a key that was armed in the present is not confirmed in the past", () => {
    const station = new Station();
    station.greet();
    station.send({ heartbeat: { source_joystick: true } });
    press("A");
    act(() => station.page.parts.get(PLAYBACK).openFlight("current", 100));
    press("Escape");
    press("Enter");
    expect(station.asked.filter(({ method }) => method !== "GET")).toEqual([]);
  });
});

describe("the playback", () => {
  test("obeys its keys wherever nothing else has the focus", () => {
    const station = inThePast();
    press(" ");
    press("ArrowRight");
    press("ArrowLeft", { shiftKey: true });
    const asked = station.replay.asked.slice(1);
    expect(asked).toEqual([
      { type: "play", rate: 1 },
      { type: "step", frames: 1 },
      { type: "seek", at_s: 99 },
    ]);
  });

  test("leaves the keys to a field in which somebody types, and to a button its space", () => {
    const station = inThePast();
    const before = station.replay.asked.length;
    const field = document.createElement("input");
    document.body.append(field);
    press("M", {}, field);
    press("Escape", {}, field);
    press(" ", {}, screen.getByRole("button", { name: "Copiar el enlace a este momento" }));
    field.remove();
    expect(station.replay.asked).toHaveLength(before);
    expect(screen.getByText("PASADO")).toBeTruthy();
    expect(screen.queryByRole("dialog")).toBeNull();
  });

  test("jumps to the next event and to the one before", async () => {
    const station = inThePast();
    await answerFlights(station);
    fireEvent.click(screen.getByRole("button", { name: "Suceso siguiente" }));
    expect(station.replay.asked.at(-1)).toEqual({ type: "seek", at_s: 200 });
    station.replayed((replay) => replay.position({ at_s: 200, jumps: 2 }));
    fireEvent.click(screen.getByRole("button", { name: "Suceso anterior" }));
    expect(station.replay.asked.at(-1)).toEqual({ type: "seek", at_s: 60 });
  });

  test("loops the stretch between two presses, and ends at the third", () => {
    const station = inThePast();
    fireEvent.click(screen.getByRole("button", { name: "Repetir un tramo desde aquí" }));
    station.replayed((replay) => replay.position({ at_s: 130 }));
    fireEvent.click(screen.getByRole("button", { name: "Repetir desde 1:40 hasta aquí" }));
    expect(station.replay.asked.at(-1)).toEqual({ type: "loop", from_s: 100, to_s: 130 });
    station.replayed((replay) => replay.position({ loop: [100, 130] }));
    fireEvent.click(screen.getByRole("button", { name: "Dejar de repetir 1:40 – 2:10" }));
    expect(station.replay.asked.at(-1)).toEqual({ type: "loop" });
  });

  test("asks for its speed at once while it plays, and with the next play while it stands", () => {
    const station = inThePast();
    const rate = screen.getByRole("combobox", { name: "Velocidad de reproducción" });
    fireEvent.change(rate, { target: { value: "10" } });
    expect(station.replay.asked.at(-1)).toEqual({ type: "pause" });
    fireEvent.click(screen.getByRole("button", { name: "Reproducir" }));
    expect(station.replay.asked.at(-1)).toEqual({ type: "play", rate: 10 });
  });

  test("goes on where it was after its line broke", () => {
    const station = inThePast();
    press(" ");
    station.replayed((replay) => replay.position({ at_s: 150, state: "playing" }));
    station.replayed((replay) => replay.wire.breakOff());
    expect(screen.getByText("Abriendo el vuelo…")).toBeTruthy();
    station.pass(300);
    expect(station.replays).toHaveLength(2);
    expect(station.replay.place).toEqual({ flight: FLIGHT, at_s: 150 });
    station.replayed((replay) => replay.greet());
    expect(station.replay.asked).toEqual([{ type: "play", rate: 1 }]);
    expect(screen.queryByText("Abriendo el vuelo…")).toBeNull();
  });

  test("sets a mark by M and Enter alone: the words can come later", async () => {
    const station = inThePast();
    const user = userEvent.setup();
    await user.keyboard("M");
    expect(document.activeElement).toBe(screen.getByRole("textbox", { name: "Qué ha pasado" }));
    await user.keyboard("{Enter}");
    const [asked] = station.asked.filter(({ method }) => method === "POST");
    expect(asked?.body).toEqual({ text: "Marca", at_s: 100 });
    await asked?.answer({});
    expect(screen.queryByRole("dialog")).toBeNull();
  });

  test("sets a mark with words at the moment that is shown", async () => {
    const station = inThePast();
    press("M");
    fireEvent.change(screen.getByRole("textbox", { name: "Qué ha pasado" }), {
      target: { value: "pérdida" },
    });
    fireEvent.click(screen.getByRole("button", { name: "Poner la marca" }));
    const [asked] = station.asked.filter(({ method }) => method === "POST");
    expect(asked?.path).toBe(`/api/v1/flights/${FLIGHT}/marks`);
    expect(asked?.body).toEqual({ text: "pérdida", at_s: 100 });
    await asked?.answer({});
    expect(screen.queryByRole("dialog")).toBeNull();
  });
});

describe("the address", () => {
  test("with a flight and a moment opens the past there", () => {
    const station = new Station(undefined, `http://station/?flight=${FLIGHT}&at=12.5`);
    expect(station.replay.place).toEqual({ flight: FLIGHT, at_s: 12.5 });
  });

  test("that names no flight opens the present", () => {
    const station = new Station(undefined, "http://station/?flight=../etc&at=1");
    expect(station.replays).toEqual([]);
  });

  test("follows the moment, and forgets it with the past", () => {
    const station = inThePast();
    expect(station.url).toBe(`http://station/?flight=${FLIGHT}&at=100.00`);
    press("Escape");
    expect(station.url).toBe("http://station/");
  });
});
