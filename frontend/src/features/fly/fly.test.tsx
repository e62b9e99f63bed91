import { act, screen } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { beforeEach, describe, expect, test } from "vitest";
import { chooseUnit } from "../../store/chosenUnits";
import { choose } from "../../store/settings";
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

test("previous and next step through the plan of the aircraft that flies", async () => {
  station.send({ ...BOARD, ...SIMULATOR });
  await user.click(screen.getByRole("button", { name: "Next" }));
  expect(station.asked.at(-1)?.path).toBe("/api/v1/commands/hil_fms_next_waypoint");
});
