import { screen, within } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { beforeEach, describe, expect, test } from "vitest";
import { Station } from "../../test/station";
import { Tab } from "../../test/tab";

const on = {
  ahrs: true,
  inertial: true,
  analog: true,
  statistics: true,
  gps: true,
  servos: true,
  fly_by_wire: true,
  source_joystick: true,
};

let station: Station;

beforeEach(() => {
  station = new Station(<Tab name="flight" />);
  station.greet();
});

function panel(title: string): HTMLElement {
  return screen.getByRole("region", { name: title });
}

function number(part: HTMLElement, name: string): string {
  return within(part).getByText(name).parentElement?.querySelector(".ui-readout-number")?.textContent ?? "";
}

async function openTab(name: string): Promise<void> {
  await userEvent.setup().click(screen.getByRole("tab", { name }));
  station.show();
}

describe("the inertial groups", () => {
  test("show all three axes in degrees a second, under the letters that the wire means", () => {
    station.send({ heartbeat: on, inertial: { gx_rad_s: Math.PI, gy_rad_s: -Math.PI / 2, gz_rad_s: 0.1 } });
    const gyros = panel("Gyros");
    expect([number(gyros, "P"), number(gyros, "Q"), number(gyros, "R")]).toEqual(["180.0", "-90.0", "5.7"]);
  });

  test("show numbers whole, however large", () => {
    station.send({ heartbeat: on, inertial: { accx_m_s2: -123.456, accy_m_s2: -0.001, accz_m_s2: -9.81 } });
    const group = panel("Acelerómetros");
    expect([number(group, "X"), number(group, "Y"), number(group, "Z")]).toEqual([
      "-123.46",
      "0.00",
      "-9.81",
    ]);
  });
});

describe("a stream that the board does not send", () => {
  test("says so, and is switched on by a command and by nothing else", async () => {
    station.send({ heartbeat: { ...on, analog: false } });
    const group = panel("Analog");
    expect(within(group).getByText("flujo apagado")).toBeTruthy();
    expect(station.asked).toEqual([]);

    await userEvent.setup().click(within(group).getByRole("button", { name: /Encender/ }));
    expect(station.asked[0]).toMatchObject({ method: "POST", path: "/api/v1/commands/analog_on" });
    await station.asked[0]?.answer({ state: "confirmed", by: "heartbeat", ms: 90, reason: null });
    station.send({ heartbeat: on, analog: { battery_v: 11.84 } });
    expect(within(panel("Analog")).queryByText("flujo apagado")).toBeNull();
    expect(number(panel("Analog"), "Vbatt")).toBe("11.84");
  });

  test("without a flag in the heartbeat is off when it is silent", async () => {
    station.send({ heartbeat: on });
    expect(screen.getByRole("button", { name: "Encender" })).toBeTruthy();
    station.send({ heartbeat: on, fms_plan: { bearing_deg: 359.97, waypoint: 3 } });
    expect(screen.queryByRole("button", { name: "Encender" })).toBeNull();
  });

  test("is not called off while the board itself is silent", () => {
    station.send({ heartbeat: { ...on, analog: false } });
    station.pass(900);
    expect(within(panel("Analog")).queryByText("flujo apagado")).toBeNull();
  });
});

test("the state report shows the flags of the heartbeat", () => {
  station.send({ heartbeat: { ...on, gps: false } });
  const report = panel("State report");
  expect(within(report).getByText("GPS").parentElement?.textContent).toContain("Off");
  expect(within(report).getByText("AHRS").parentElement?.textContent).toContain("On");
});

test("Read All asks the board for every stream once", async () => {
  station.send({ heartbeat: on });
  await userEvent.setup().click(screen.getByRole("button", { name: "Read All" }));
  expect(station.asked[0]).toMatchObject({ method: "POST", path: "/api/v1/commands/read_all" });
});

describe("the sub tabs", () => {
  test("of the receiver tell a fix from none", async () => {
    station.send({ heartbeat: on, gps: { fix: 1, valid: true, satellites: 12 } });
    await openTab("GPS status");
    const tab = screen.getByRole("tabpanel", { name: "GPS status" });
    expect(tab.textContent).toContain("Fijada");
    expect(number(tab, "SatellitesUsed")).toBe("12");
    station.send({ heartbeat: on, gps: { fix: 1, valid: false, satellites: 0 } });
    expect(tab.textContent).toContain("Sin fijar");
  });

  test("of the processors show their load", async () => {
    station.send({ heartbeat: on, statistics: { sensor_dsc_percent: 45, control_dsc_percent: 7 } });
    await openTab("Uso de la CPU");
    const tab = screen.getByRole("tabpanel", { name: "Uso de la CPU" });
    expect([number(tab, "SensorDSC"), number(tab, "ControlDSC")]).toEqual(["45", "7"]);
  });

  test("of the plan never call north 360, and step through the waypoints", async () => {
    station.send({
      heartbeat: on,
      fms_plan: { bearing_deg: 359.97, altitude_ft: 1000, distance_m: 1380, waypoint: 3 },
    });
    const tab = screen.getByRole("tabpanel", { name: "FMS" });
    expect([number(tab, "Rumbo"), number(tab, "Waypoint")]).toEqual(["0.0", "3"]);
    await userEvent.setup().click(within(tab).getByRole("button", { name: "Next" }));
    expect(station.asked[0]).toMatchObject({ path: "/api/v1/commands/fms_next_waypoint" });
  });

  test("of the RC channels are twelve bars that nobody can move", async () => {
    await openTab("ServosIn");
    station.send({ heartbeat: on, servos_in: { channel_0: -1, channel_2: 0.65 } });
    const tab = screen.getByRole("tabpanel", { name: "ServosIn" });
    expect(tab.querySelectorAll(".inst-servo")).toHaveLength(12);
    expect(tab.querySelectorAll("input")).toHaveLength(0);
    expect(tab.querySelector(".inst-servo")?.getAttribute("data-value")).toBe("-1.000");
    station.pass(900);
    expect(tab.querySelector(".inst-servo")?.getAttribute("data-state")).toBe("none");
  });

  test("stand in their order", () => {
    const row = screen.getByRole("tablist", { name: "Navegación y servos" });
    expect(
      within(row)
        .getAllByRole("tab")
        .map((tab) => tab.textContent),
    ).toEqual(["FMS", "GPS", "ServosIn", "ServosOut", "Fly-by-wire", "Refresco"]);
  });
});
