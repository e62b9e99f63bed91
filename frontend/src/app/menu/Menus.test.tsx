import { screen, within } from "@testing-library/react";
import userEvent, { type UserEvent } from "@testing-library/user-event";
import { describe, expect, test } from "vitest";
import { aStatus } from "../../test/aStatus";
import { Station } from "../../test/station";

const flags = {
  analog: true,
  inertial: false,
  ahrs: true,
  statistics: true,
  gps: true,
  servos: true,
  fly_by_wire: true,
  autopilot_hil: true,
  autotrim_hil: false,
  source_joystick: true,
};

/** Without the check of all styles above an element before each click, which takes seconds. */
const QUICK = { pointerEventsCheck: 0, delay: null } as const;

function flying(status = aStatus()): Station {
  const station = new Station();
  station.greet(status);
  station.send({
    heartbeat: flags,
    board_status: { airspeed_source: 1, altitude_source: 0, servos_control_mode: 1, hil_plan_name: 2 },
    fms_plan: { waypoint: 3 },
  });
  return station;
}

/** Open a menu with the keyboard. Found by its text, because a search by role through the whole page takes seconds. */
async function open(user: UserEvent, station: Station, menu: string): Promise<HTMLElement> {
  within(screen.getByLabelText("Menús")).getByText(menu).focus();
  await user.keyboard("{Enter}");
  station.show();
  return openMenu();
}

function openMenu(): HTMLElement {
  const menu = document.querySelector<HTMLElement>('[role="menu"]');
  if (menu === null) {
    throw new Error("no menu is open");
  }
  return menu;
}

/** The last entry of this name: "Fly-by-wire" stands in a menu and in the name of its group. */
function entry(name: string): HTMLElement {
  const found = within(openMenu()).getAllByText(name).at(-1)?.closest<HTMLElement>('[role^="menuitem"]');
  if (!found) {
    throw new Error(`no entry ${name}`);
  }
  return found;
}

/** The page's requests, without those that only read. */
function asked(station: Station): string[] {
  return station.asked
    .filter(({ method }) => method !== "GET")
    .map(({ method, path, body }) => {
      const address = path.replace("/api/v1/", "");
      return `${method} ${address} ${JSON.stringify(body ?? {})}`;
    });
}

/** Choose each entry of a menu in turn, opening the menu again where it closes. */
async function chooseAll(station: Station, menu: string, names: readonly string[]): Promise<string[]> {
  const user = userEvent.setup(QUICK);
  for (const name of names) {
    if (document.querySelector('[role="menu"]') === null) {
      await open(user, station, menu);
    }
    await user.click(entry(name));
  }
  return asked(station);
}

const command = (name: string, value?: number): string =>
  `POST commands/${name} ${value === undefined ? "{}" : `{"value":${value}}`}`;

describe("each entry asks for what it says", () => {
  test("Autopilot", async () => {
    const names = ["On", "Off", "Autotrim On", "Autotrim Off"];
    expect(await chooseAll(flying(), "Autopilot", names)).toEqual([
      command("autopilot_on"),
      command("autopilot_off"),
      command("autotrim_on"),
      command("autotrim_off"),
    ]);
  });

  test("Autopilot, the two selectors", async () => {
    const station = flying();
    const user = userEvent.setup(QUICK);
    await open(user, station, "Autopilot");
    const speed = within(openMenu()).getByRole("group", { name: "Selector de velocidad" });
    const altitude = within(openMenu()).getByRole("group", { name: "Selector de altura" });
    const chosen = (group: HTMLElement) =>
      within(group)
        .getAllByRole("menuitemradio")
        .filter((item) => item.getAttribute("aria-checked") === "true")
        .map((item) => item.textContent);
    expect([chosen(speed), chosen(altitude)]).toEqual([["Tubo Pitot"], ["GPS"]]);
    await user.click(within(speed).getByRole("menuitemradio", { name: "GPS" }));
    await user.click(within(altitude).getByRole("menuitemradio", { name: "Baro" }));
    expect(asked(station)).toEqual([
      command("select_airspeed_source", 0),
      command("select_altitude_source", 1),
    ]);
  });

  test("Parámetros: a stream that is on is switched off, one that is off on", async () => {
    const names = [
      "Start",
      "Stop",
      "Sensores Analógicos",
      "Sensores Inerciales",
      "AHRS",
      "Estadísticas",
      "GPS",
      "ServosIn",
      "Fly-by-wire",
      "FMS Fly plan On",
      "FMS Fly plan Off",
      "FMS HIL Fly plan On",
      "FMS HIL Fly plan Off",
      "Emulación",
    ];
    expect(await chooseAll(flying(), "Parámetros", names)).toEqual([
      command("start"),
      command("stop"),
      command("analog_off"),
      command("inertial_on"),
      command("ahrs_off"),
      command("statistics_off"),
      command("gps_off"),
      command("servos_in_off"),
      command("fly_by_wire_off"),
      command("fms_plan_on"),
      command("fms_plan_off"),
      command("fms_hil_plan_on"),
      command("fms_hil_plan_off"),
      'PUT links/board {"url":"emulation:"}',
    ]);
  });

  test("Control Aeronave", async () => {
    const names = ["Plane RC", "Plane Joystick", "Fly-by-wire", "HIL"];
    expect(await chooseAll(flying(), "Control Aeronave", names)).toEqual([
      'PUT hil {"source":"rc"}',
      'PUT hil {"source":"joystick"}',
      command("servos_control_mode_fly_by_wire"),
      command("servos_control_mode_hil"),
    ]);
  });

  test("XPlane", async () => {
    const names = [
      "HIL Load Gando",
      "HIL Load Ruta Isla",
      "HIL Load Alternativa",
      "HIL Load Vuelo",
      "HIL Next Waypoint",
      "HIL Prev Waypoint",
      "Joystick",
      "Fly-by-wire",
    ];
    const station = flying();
    station.send({ heartbeat: { ...flags, autopilot_hil: false } });
    expect(await chooseAll(station, "XPlane", names)).toEqual([
      command("hil_load_gando"),
      command("hil_load_ruta_isla"),
      command("hil_load_alternativa"),
      command("hil_load_vuelo"),
      command("hil_fms_next_waypoint"),
      command("hil_fms_previous_waypoint"),
      'PUT hil {"path":"manual"}',
      'PUT hil {"path":"assisted"}',
    ]);
  });
});

describe("what does not come back by itself", () => {
  test("is asked first: X-Plane by hand in automatic flight", async () => {
    const station = flying();
    const user = userEvent.setup(QUICK);
    await open(user, station, "XPlane");
    await user.click(entry("Joystick"));
    expect(asked(station)).toEqual([]);
    const question = screen.getByRole("alertdialog", { name: "¿Llevar X-Plane a mano?" });
    await user.click(within(question).getByRole("button", { name: "Llevar a mano" }));
    expect(asked(station)).toEqual(['PUT hil {"path":"manual"}']);
  });

  test("is asked first: another route while the HIL autopilot flies", async () => {
    const station = flying();
    const user = userEvent.setup(QUICK);
    await open(user, station, "XPlane");
    await user.click(entry("HIL Load Vuelo"));
    expect(asked(station)).toEqual([]);
    const question = screen.getByRole("alertdialog", { name: "¿Cargar una ruta en vuelo?" });
    await user.click(within(question).getByRole("button", { name: "Cargar y volarla" }));
    expect(asked(station)).toEqual([command("hil_load_vuelo")]);
  });

  test("is asked first: the board's Reset", async () => {
    const station = flying();
    const user = userEvent.setup(QUICK);
    await open(user, station, "Autopilot");
    await user.click(entry("Reset"));
    const question = screen.getByRole("alertdialog", { name: "¿Reiniciar el piloto automático?" });
    await user.click(within(question).getByRole("button", { name: "Cancelar" }));
    expect(asked(station)).toEqual([]);
    await open(user, station, "Autopilot");
    await user.click(entry("Reset"));
    await user.click(screen.getByRole("button", { name: "Reiniciar" }));
    expect(asked(station)).toEqual([command("reset")]);
  });

  test("is asked first: the drawn track, which can be brought back", async () => {
    const station = flying();
    const user = userEvent.setup(QUICK);
    await open(user, station, "Google Earth");
    await user.click(entry("Reset"));
    expect(asked(station)).toEqual([]);
    await user.click(screen.getByRole("button", { name: "Borrar el recorrido" }));
    await open(user, station, "Google Earth");
    await user.click(entry("Recuperar el recorrido anterior"));
    expect(asked(station)).toEqual(["POST track/reset {}", "POST track/restore {}"]);
  });
});

test("Google Earth gives the live link and the track as files", async () => {
  const station = flying();
  const user = userEvent.setup(QUICK);
  await open(user, station, "Google Earth");
  expect(entry("Abrir en Google Earth").getAttribute("href")).toBe("/api/v1/earth.kml?lang=es");
  expect(entry("Exportar KML").getAttribute("href")).toBe("/api/v1/track.kml?lang=es");
});

describe("an entry shows", () => {
  test("how things stand", async () => {
    const station = flying();
    const user = userEvent.setup(QUICK);
    await open(user, station, "Autopilot");
    expect(entry("On").getAttribute("aria-current")).toBe("true");
    expect(entry("Autotrim Off").getAttribute("aria-current")).toBe("true");
    await user.keyboard("{Escape}");
    await open(user, station, "XPlane");
    expect(entry("HIL Load Alternativa").getAttribute("aria-current")).toBe("true");
    expect(entry("HIL Load Gando").getAttribute("aria-current")).toBeNull();
  });

  test("what became of its command, the menu still being open", async () => {
    const station = flying();
    const user = userEvent.setup(QUICK);
    await open(user, station, "Parámetros");
    await user.click(entry("Sensores Inerciales"));
    station.show();
    expect(entry("Sensores Inerciales").getAttribute("aria-checked")).toBe("false");
    expect(entry("Sensores Inerciales").textContent).toContain("pendiente");
    await station.asked.at(-1)?.answer({ state: "confirmed", by: "heartbeat", ms: 80, reason: null });
    station.send({ heartbeat: { ...flags, inertial: true } });
    expect(entry("Sensores Inerciales").getAttribute("aria-checked")).toBe("true");
    expect(entry("Sensores Inerciales").textContent).toContain("confirmado por el latido");
  });

  test("why it cannot be chosen, and answers a press with that", async () => {
    const legacy = aStatus({
      board: {
        ...aStatus().board,
        mode: "legacy",
        features: { acknowledgements: false, store: false, sources: false, missions: false },
      },
    });
    const station = flying(legacy);
    const user = userEvent.setup(QUICK);
    await open(user, station, "Autopilot");
    const speed = within(openMenu()).getByRole("group", { name: "Selector de velocidad" });
    expect(speed.textContent).toContain("necesita un firmware con extensiones");
    await user.click(within(speed).getByRole("menuitemradio", { name: "GPS" }));
    expect(asked(station)).toEqual([]);
    expect(station.page.messages.getState().last).toMatchObject({ key: "said.notDone" });
  });

  test("that its position is not known while the heartbeat is late, and asks for the other one than it saw last", async () => {
    const station = flying();
    const user = userEvent.setup(QUICK);
    station.pass(700);
    station.status(aStatus());
    await open(user, station, "Parámetros");
    expect(entry("AHRS").textContent).toContain("no llega el latido");
    expect(entry("AHRS").getAttribute("aria-checked")).toBe("false");
    await user.click(entry("AHRS"));
    await user.click(entry("Sensores Inerciales"));
    expect(asked(station)).toEqual([command("ahrs_off"), command("inertial_on")]);
  });

  test("that nothing was heard of its position, and answers a press with that", async () => {
    const station = new Station();
    station.greet();
    const user = userEvent.setup(QUICK);
    await open(user, station, "Parámetros");
    await user.click(entry("AHRS"));
    expect(asked(station)).toEqual([]);
    expect(station.page.messages.getState().last).toMatchObject({ key: "said.notDone" });
  });
});

test("the menus are walked with the keyboard alone", async () => {
  const station = flying();
  // Base UI moves the focus a moment after the key: here the keys come one by one.
  const user = userEvent.setup();
  within(screen.getByLabelText("Menús")).getByText("Autopilot").focus();
  await user.keyboard("{ArrowRight}{Enter}");
  station.show();
  expect(entry("Sensores Analógicos")).toBeTruthy();
  await user.keyboard("{ArrowDown}{Enter}");
  expect(asked(station)).toEqual([command("stop")]);
});
