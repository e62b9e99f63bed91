import { act, screen, within } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { beforeEach, describe, expect, test } from "vitest";
import { chooseUnit } from "../../store/chosenUnits";
import { choose } from "../../store/settings";
import { aStatus } from "../../test/aStatus";
import { Station } from "../../test/station";

const user = userEvent.setup();
let station: Station;

beforeEach(() => {
  station = new Station();
  station.greet();
  act(() => choose(station.page.settings, "tab", "fly"));
});

const BOARD = {
  heartbeat: { ahrs: true, analog: true, gps: true, autopilot: true, autopilot_hil: false },
  ahrs: { yaw_deg: 350, pitch_deg: 5, roll_deg: -20 },
  analog: { calibrated_airspeed_kt: 55, altitude_m: 304.8, vvi_ft_min: -700, battery_v: 12.3 },
  gps: { altitude_m: 609.6, speed_kt: 61, fix: 1, valid: true },
  fms_plan: { waypoint: 2, distance_m: 890, altitude_ft: 1100, speed_kt: 60, bearing_deg: 42 },
};
const SIMULATOR = {
  simulator: {
    indicated_airspeed_kt: 70,
    altitude_indicated_ft: 2000,
    pitch_deg: 1,
    roll_deg: 2,
    true_heading_deg: 90,
    vvi_ft_min: 100,
  },
  board_status: { hil_plan_name: 0 },
  fms_hil_plan: { waypoint: 0, distance_m: null, altitude_ft: 2100, speed_kt: 65, bearing_deg: 80 },
};

function tape(name: string): HTMLElement {
  return screen.getByRole("img", { name });
}

function speed(): HTMLElement {
  return tape("Velocidad");
}

function altitude(): HTMLElement {
  return tape("Altitud barométrica");
}

function sentence(): string {
  return document.querySelector(".fly-sentence")?.textContent ?? "";
}

function figures(): string[] {
  // Also behind the open dialog.
  return [...document.querySelectorAll(".fly-figures dt")].map((name) => name.textContent);
}

function pass(seconds: number): void {
  for (let tenth = 0; tenth < 10 * seconds; tenth += 1) {
    station.pass(100);
  }
}

describe("the primary display", () => {
  test("is crossed out until something is heard", () => {
    expect([speed(), altitude()].map(({ dataset }) => dataset["state"])).toEqual(["none", "none"]);
    expect(sentence()).toBe("Aeronave, todavía no se recibe nada de ella");
  });

  test("shows the aircraft's speed and altitude, and what its plan asks for", () => {
    station.send(BOARD);
    expect(speed().dataset).toMatchObject({ state: "live", airspeedKt: "55.0", target: "shown" });
    expect(altitude().dataset).toMatchObject({ state: "live", altitudeFt: "1000.0", target: "shown" });
    expect(speed().querySelector(".tape-window")?.textContent).toBe("55.0");
    expect(altitude().querySelector(".tape-window")?.textContent).toBe("1000");
    expect(sentence()).toBe("Aeronave, con piloto automático, hacia el waypoint 3, a 890 m");
  });

  test("is in the unit that the user chose", () => {
    act(() => chooseUnit(station.page.settings, "altitude", "m"));
    station.send(BOARD);
    expect(altitude().querySelector(".tape-window")?.textContent).toBe("304.8");
    expect(altitude().dataset["altitudeFt"]).toBe("1000.0");
  });

  test("shows the simulator's aircraft as soon as it is heard, with its own plan, and says that it is simulated", () => {
    station.send({ ...BOARD, ...SIMULATOR });
    station.show();
    expect(speed().dataset["airspeedKt"]).toBe("70.0");
    expect(altitude().dataset["altitudeFt"]).toBe("2000.0");
    expect(sentence()).toBe("Vuelo simulado: ruta Gando, a mano, hacia el waypoint 1");
  });

  test("is crossed out when its aircraft falls silent, and the other one does not take its place", () => {
    station.send({ ...BOARD, ...SIMULATOR });
    for (let second = 0; second < 5; second += 1) {
      pass(1);
      station.send(BOARD);
    }
    expect(speed().dataset["state"]).toBe("none");
    expect(speed().dataset["airspeedKt"]).toBeUndefined();
    expect(sentence()).toContain("ha dejado de recibirse");
  });

  test("says at once that the station is gone", () => {
    station.send(BOARD);
    station.breakOff();
    expect(sentence()).toContain("no hay conexión con la estación");
    expect(sentence()).not.toContain("piloto automático");
  });
});

test("a flight of the past says that it is one, and has its own values", () => {
  station.send(BOARD);
  station.openFlight("20260131T120000Z", 10);
  station.replayed((replay) => {
    replay.greet();
    replay.send({ ...BOARD, analog: { ...BOARD.analog, calibrated_airspeed_kt: 42 } });
  });
  station.show();
  expect(sentence()).toBe("Vuelo grabado, con piloto automático, hacia el waypoint 3, a 890 m");
  expect(speed().dataset["airspeedKt"]).toBe("42.0");
});

test("the six figures are chosen by the person, kept, and go back to the usual ones", async () => {
  station.send(BOARD);
  expect(figures()).toEqual(["Suelo", "Ascenso", "Sobre el terreno", "Al waypoint", "Batería", "Viento"]);
  await user.click(screen.getByRole("button", { name: "Elegir las cifras de vuelo" }));
  await user.selectOptions(screen.getByRole("combobox", { name: "Cifra 2" }), "Satélites");
  expect(figures()[1]).toBe("Satélites");
  expect(station.page.settings.getState().choices["fly.figures"]).toBe(
    "groundSpeed satellites height distance battery wind",
  );
  await user.click(screen.getByRole("button", { name: "Las de siempre" }));
  expect(figures()[1]).toBe("Ascenso");
});

describe("the modes over the horizon", () => {
  function modes(): string[] {
    return [...document.querySelectorAll(".modes-cell:not(.modes-age)")].map((cell) =>
      [".modes-name", ".modes-word"].map((part) => cell.querySelector(part)?.textContent).join(" "),
    );
  }
  function stateOf(name: string): string | undefined {
    const cells = [...document.querySelectorAll<HTMLElement>(".modes-cell")];
    return cells.find((cell) => cell.querySelector(".modes-name")?.textContent === name)?.dataset["state"];
  }
  const heartbeat = { ...BOARD.heartbeat, source_joystick: true, autopilot_hil: true, autotrim_hil: false };
  const board_status = { hil_plan_name: 0, airspeed_source: 1, altitude_source: 0 };

  test("are read from live values, and not known without them", () => {
    station.send({ ...BOARD, ...SIMULATOR, heartbeat, board_status });
    expect(modes()).toEqual(["Fuente Joystick", "Camino FBW", "AP On", "Trim Off", "Vel. Pitot", "Alt. GPS"]);
    expect(stateOf("AP")).toBe("active");
    station.breakOff();
    expect(modes().map((mode) => mode.replace(/^\S+ /, ""))).toEqual(Array(6).fill("– – –"));
    expect(stateOf("AP")).toBe("unknown");
  });

  test("say that the autopilot is only armed while the stick goes past the board", () => {
    station.status(aStatus({ hil: { ...aStatus().hil, path: "manual" } }));
    station.send({ ...BOARD, ...SIMULATOR, heartbeat, board_status });
    expect(modes()).toContain("AP Armado");
    expect(stateOf("AP")).toBe("armed");
  });

  test("have no path for an aircraft that flies with its board", () => {
    station.send({ ...BOARD, heartbeat: { ...heartbeat, autopilot: false }, board_status });
    expect(modes()).toEqual(["Fuente Joystick", "AP Off", "Trim – – –", "Vel. Pitot", "Alt. GPS"]);
  });

  test("open the control path with its switches", async () => {
    station.send({ ...BOARD, ...SIMULATOR, heartbeat, board_status });
    await user.click(screen.getByRole("button", { name: /^Modos;/ }));
    const dialog = screen.getByRole("dialog", { name: "Camino de la señal de control" });
    for (const name of ["X-Plane", "Fuente", "Autopilot", "Autotrim"]) {
      expect(within(dialog).getByRole("group", { name })).toBeTruthy();
    }
  });

  test("show what was asked for and refused", async () => {
    station.send({ ...BOARD, ...SIMULATOR, heartbeat, board_status });
    await user.click(screen.getByRole("button", { name: /^Modos;/ }));
    const autopilot = within(screen.getByRole("dialog")).getByRole("group", { name: "Autopilot" });
    await user.click(within(autopilot).getByText("Off"));
    const cell = document.querySelectorAll<HTMLElement>(".modes-cell")[2];
    expect(cell?.dataset["asked"]).toBe("pending");
    await station.asked.at(-1)?.answer({ code: "refused", title: "no", status: 409 }, 409);
    expect(cell?.dataset["asked"]).toBe("rejected");
  });
});

test("a press on a figure opens its plot, or says why there is none", async () => {
  station.send(BOARD);
  await user.click(screen.getByRole("button", { name: "Gráfica de Viento" }));
  expect(screen.getByRole("status", { name: "Último mensaje" }).textContent).toContain(
    "Lo calcula esta página",
  );
  await user.click(screen.getByRole("button", { name: "Gráfica de Batería" }));
  const { choices } = station.page.settings.getState();
  expect(choices["tab"]).toBe("plots");
  expect(JSON.parse(choices["plots.panes"] ?? "[]")[0]).toEqual(["analog.battery_v"]);
});

describe("a press on a tape", () => {
  test("changes the altitude of the waypoint that is flown to, and sends the plan", async () => {
    station.send({ ...BOARD, ...SIMULATOR, heartbeat: { ...BOARD.heartbeat, source_joystick: true } });
    await user.click(screen.getByRole("button", { name: "Cambiar la altitud que pide el plan" }));
    const field = within(screen.getByRole("dialog")).getByRole("textbox");
    await user.clear(field);
    await user.type(field, "1200");
    await user.click(screen.getByRole("button", { name: "Cambiar y enviar" }));
    const asked = station.asked.at(-1);
    expect(asked).toMatchObject({ method: "PUT", path: "/api/v1/missions/hil" });
    const sent = asked?.body as { readonly waypoints: ReadonlyArray<{ altitude_ft: number }> } | undefined;
    const altitudes_ft = sent?.waypoints.map(({ altitude_ft }) => altitude_ft) ?? [];
    expect(altitudes_ft[0]).toBe(1200);
    expect(altitudes_ft.slice(1)).not.toContain(1200);
  });

  test("says why nothing can be changed", async () => {
    station.send({ ...BOARD, fms_plan: { ...BOARD.fms_plan, waypoint: null } });
    await user.click(screen.getByRole("button", { name: "Cambiar la velocidad que pide el plan" }));
    const dialog = screen.getByRole("dialog");
    expect(dialog.textContent).toContain("No se sabe qué plan tiene la placa");
    const sent = station.asked.length;
    await user.click(within(dialog).getByRole("button", { name: "Cambiar y enviar" }));
    expect(station.asked).toHaveLength(sent);
  });
});

test("a mark is among the flight's controls, and needs a recording", async () => {
  const bar = within(screen.getByRole("toolbar", { name: "Mandos de vuelo" }));
  const mark = (): HTMLElement => bar.getByRole("button", { name: "Poner una marca en este momento" });
  station.status(aStatus({ recording: { ...aStatus().recording, active: false } }));
  expect(mark().getAttribute("aria-disabled")).toBe("true");
  station.status(aStatus());
  await user.click(mark());
  expect(screen.getByRole("dialog", { name: "Marca ahora" })).toBeTruthy();
});

test("the plan's profile is folded at first in a window of usual size", async () => {
  station.send({ ...BOARD, ...SIMULATOR });
  expect(screen.queryByRole("img", { name: /^Perfil de altura del plan/ })).toBeNull();
  await user.click(screen.getByRole("button", { name: "Desplegar Perfil" }));
  expect(screen.getByRole("img", { name: /^Perfil de altura del plan: 8 waypoints/ })).toBeTruthy();
});

test("previous and next step through the plan of the aircraft that flies", async () => {
  station.send({ ...BOARD, ...SIMULATOR });
  await user.click(screen.getByRole("button", { name: "Next" }));
  expect(station.asked.at(-1)?.path).toBe("/api/v1/commands/hil_fms_next_waypoint");
});
