import { screen, within } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { describe, expect, test } from "vitest";
import { aStatus } from "../test/aStatus";
import { Station } from "../test/station";
import { TABS } from "./views/views";

const heartbeat = {
  autopilot: false,
  autotrim: false,
  auto_switch: false,
  servos: true,
  gps: true,
  statistics: true,
  ahrs: true,
  inertial: true,
  analog: true,
  fly_by_wire: true,
  autopilot_hil: true,
  source_joystick: true,
  autotrim_hil: false,
};
const ahrs = { yaw_deg: -170, pitch_deg: -5.25, roll_deg: 30 };

function flying(): Station {
  const station = new Station();
  station.greet();
  station.send({ heartbeat, ahrs });
  return station;
}

function left(): HTMLElement {
  return screen.getByRole("complementary");
}

/** A readout by its name in a part of the page: its number and its state. */
function reading(part: HTMLElement, name: string): { text: string; state: string | undefined } {
  const label = within(part).getByText(name);
  const row = label.parentElement;
  return {
    text: row?.querySelector(".ui-readout-number")?.textContent ?? "",
    state: row?.dataset["state"],
  };
}

describe("what is measured", () => {
  test("is shown whole, with its sign, a heading from 0 to 360", () => {
    flying();
    expect(reading(left(), "Heading")).toEqual({ text: "190.0", state: "live" });
    expect(reading(left(), "Pitch")).toEqual({ text: "-5.3", state: "live" });
    expect(screen.getByRole("img", { name: "Indicador de actitud" }).dataset["rollDeg"]).toBe("30.0");
  });

  test("and not heard is no data, never a zero or a level attitude", () => {
    const station = new Station();
    station.greet();
    expect(reading(left(), "Pitch").state).toBe("none");
    expect(reading(left(), "Pitch").text).not.toMatch(/\d/);
    expect(screen.getByRole("img", { name: "Indicador de actitud" }).dataset["state"]).toBe("none");
  });

  test("as no number (null) is no data while its stream is live", () => {
    const station = flying();
    station.send({ heartbeat, ahrs: { ...ahrs, pitch_deg: null } });
    expect(reading(left(), "Pitch").state).toBe("none");
    expect(reading(left(), "Roll").state).toBe("live");
    expect(screen.getByRole("img", { name: "Indicador de actitud" }).dataset["state"]).toBe("none");
  });

  test("grows stale when its stream stops: numbers marked, instruments crossed out", () => {
    const station = flying();
    station.pass(400);
    station.status(aStatus());
    expect(reading(left(), "Pitch")).toEqual({ text: "-5.3", state: "stale" });
    expect(screen.getByRole("img", { name: "Indicador de actitud" }).dataset["state"]).toBe("none");
    expect(screen.getByRole("img", { name: "Indicador de rumbo" }).dataset["state"]).toBe("none");
  });

  test("comes back to life with the next sample", () => {
    const station = flying();
    station.pass(800);
    station.send({ heartbeat, ahrs });
    expect(reading(left(), "Pitch").state).toBe("live");
  });
});

describe("the gateway's silence", () => {
  test("is an alarm on every tab and stops every control but Manual", () => {
    const station = flying();
    station.pass(1400);
    expect(screen.getByRole("alert").textContent).toContain("La estación no dice nada");
    expect(reading(left(), "Pitch").state).toBe("stale");
    const path = screen.getByRole("radio", { name: "Ordenador de a bordo" });
    expect(path.getAttribute("aria-disabled")).toBe("true");
  });

  test("after a break is an alarm until the line is back, under the old name", () => {
    const station = flying();
    station.breakOff();
    expect(screen.getByRole("alert").textContent).toContain("No hay conexión con la estación");
    // Immediately, although the samples are still recent.
    expect(reading(left(), "Pitch").state).toBe("stale");
    expect(screen.getByRole("img", { name: "Indicador de actitud" }).dataset["state"]).toBe("none");
    station.pass(300);
    expect(station.clients).toEqual([null, "c1"]);
    station.greet();
    station.send({ heartbeat, ahrs });
    expect(screen.getByRole("alert").textContent).toBe("");
    expect(reading(left(), "Pitch").state).toBe("live");
  });
});

describe("the gateway's alarms", () => {
  const since = {
    since_s: 1,
    until_s: null,
    acknowledged: false,
    count: 1,
    params: { target: "/dev/ttyUSB0" },
  };

  test("are said in the page's language, with what they are about", () => {
    const station = flying();
    station.status(
      aStatus({
        alarms: [{ id: "heartbeat_lost", level: "critical", text: "The heartbeat is lost.", ...since }],
      }),
    );
    expect(screen.getByRole("alert").textContent).toContain(
      "Se ha perdido el latido de la placa en /dev/ttyUSB0",
    );
  });

  test("that this page does not know are said as the gateway says them", () => {
    const station = flying();
    station.status(
      aStatus({ alarms: [{ id: "new_one", level: "critical", text: "Something new.", ...since }] }),
    );
    expect(screen.getByRole("alert").textContent).toContain("Something new.");
  });
});

const GROUPS = {
  Vuelo: ["Vista de vuelo", "Datos de vuelo", "Standard Six"],
  Planes: ["Planes de vuelo", "Mapa 3D"],
  "Autopilot Param": [],
  HIL: ["HIL", "HIL Standard Six", "AHRS 3D"],
  Vuelos: ["Vuelos", "Gráficas"],
  "Mensajes y alarmas": ["Mensajes", "Alarmas"],
  Setup: [],
} as const;

function tabNames(list: string): string[] {
  const row = screen.queryByRole("tablist", { name: list });
  return row === null
    ? []
    : within(row)
        .getAllByRole("tab")
        .map((tab) => tab.textContent);
}

async function pressTab(list: string, name: string): Promise<void> {
  await userEvent
    .setup()
    .click(within(screen.getByRole("tablist", { name: list })).getByRole("tab", { name }));
}

describe("the tabs", () => {
  test("stand in groups in the order of work, those of the open group beside them", async () => {
    flying();
    expect(tabNames("Pestañas principales")).toEqual(Object.keys(GROUPS));
    for (const [group, tabs] of Object.entries(GROUPS)) {
      await pressTab("Pestañas principales", group);
      expect(tabNames(`Pestañas de ${group}`)).toEqual(tabs);
    }
  });

  test("of a group: the one last open is open again when the group is", async () => {
    flying();
    await pressTab("Pestañas principales", "HIL");
    await pressTab("Pestañas de HIL", "AHRS 3D");
    await pressTab("Pestañas principales", "Vuelo");
    expect(screen.getByRole("tabpanel", { name: "Datos de vuelo" })).toBeTruthy();
    await pressTab("Pestañas principales", "HIL");
    expect(screen.getByRole("tabpanel", { name: "AHRS 3D" })).toBeTruthy();
  });

  test("have an address each, which follows the open one and opens it", async () => {
    const station = flying();
    await pressTab("Pestañas principales", "Setup");
    expect(station.url).toBe("http://station/#tab=setup");
    station.goTo("http://station/#tab=hilsix");
    expect(screen.getByRole("tabpanel", { name: "HIL Standard Six" })).toBeTruthy();
    station.goTo("http://station/#tab=none");
    expect(screen.getByRole("tabpanel", { name: "HIL Standard Six" })).toBeTruthy();
  });

  test("send nothing by being opened", () => {
    const station = flying();
    for (const tab of TABS.toReversed()) {
      station.openTab(tab);
    }
    expect(station.asked.filter(({ method }) => method !== "GET")).toEqual([]);
  });
});

test("English is one press away and every fixed text changes", async () => {
  flying();
  await userEvent.setup().click(screen.getByRole("radio", { name: "English" }));
  expect(document.documentElement.lang).toBe("en");
  expect(screen.getByRole("tab", { name: "Flight data" })).toBeTruthy();
  expect(screen.getByRole("img", { name: "Attitude indicator" })).toBeTruthy();
});

test("a batch that was taken is acknowledged", () => {
  const station = flying();
  expect(station.wires[0]?.sent).toEqual(['{"type":"ack","seq":1}']);
});

test("a message that is not as agreed is said and changes nothing", () => {
  const station = flying();
  station.deliver({
    type: "batch",
    seq: 9,
    t_s: 1,
    samples: [{ topic: "ahrs", t_s: 1, values: { roll_deg: "30" } }],
  });
  expect(screen.getByRole("status", { name: "Último mensaje" }).textContent).toContain("no entiende");
  expect(reading(left(), "Roll").text).toBe("30.0");
});

test("a line that is lost is told, and told again when it is back", () => {
  const station = flying();
  const said = () => screen.getByRole("status", { name: "Último mensaje" }).textContent;
  station.status(aStatus({ board: { ...aStatus().board, state: "lost" } }));
  expect(said()).toContain("Placa: perdido.");
  station.status(aStatus({ board: { ...aStatus().board, state: "opening" } }));
  expect(said()).toContain("Placa: perdido.");
  station.status(aStatus());
  expect(said()).toContain("Placa: conectado.");
});
