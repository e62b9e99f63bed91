import { screen, within } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { beforeEach, expect, test } from "vitest";
import { aStatus } from "../../test/aStatus";
import { Station } from "../../test/station";
import { Tab } from "../../test/tab";

let station: Station;

beforeEach(() => {
  station = new Station(<Tab name="hil" />);
  station.greet();
});

function number(panel: string, name: string): string {
  const part = screen.getByRole("region", { name: panel });
  return within(part).getByText(name).parentElement?.querySelector(".ui-readout-number")?.textContent ?? "";
}

test("every value of the simulator is shown in its own unit", () => {
  station.send({
    simulator: {
      true_heading_deg: -1,
      pitch_deg: 5.5,
      indicated_airspeed_kt: 55.25,
      altitude_indicated_ft: 991.4,
      q_rad_s: 0.1,
      alpha_deg: 2.314,
      mach: 0.0834,
      vvi_ft_min: -1234.5,
      g_normal: 1.04,
      latitude_deg: 27.948013,
    },
  });
  expect(number("AHRS", "Heading")).toBe("359.0");
  expect(number("ADS", "Vind")).toBe("55.3");
  expect(number("ADS", "Altura")).toBe("991");
  expect(number("Gyros", "Q")).toBe("5.7");
  expect(number("AoA, paths", "AoA")).toBe("2.31");
  expect(number("Mach, VVI, Gload", "Mach")).toBe("0.083");
  expect(number("Mach, VVI, Gload", "VVI")).toMatch(/^-123[45]$/);
  expect(number("GPS", "Latitud")).toBe("27.948013");
});

test("the simulator's own words say what they mean", () => {
  expect(screen.getByText("Gnorml").title).toBe("Factor de carga perpendicular a las alas");
  expect(screen.getByText("hding").title).toBe("Rumbo de la trayectoria sobre el suelo");
});

test("a row that has not arrived gives no values", () => {
  station.send({ simulator: { mach: 0.08 } });
  expect(number("ADS", "Vind")).not.toMatch(/\d/);
});

test("what the board does to the surfaces moves the bars, and silence empties them", () => {
  const surfaces = screen.getByRole("region", { name: "Fly-by-wire" });
  station.send({ hil_surfaces: { elevator: -0.12, aileron: 0.3, rudder: 0, throttle: 0.62 } });
  expect([...surfaces.querySelectorAll(".inst-servo")].map((bar) => bar.getAttribute("data-value"))).toEqual([
    "-0.120",
    "0.300",
    "0.000",
    "0.620",
  ]);
  station.pass(900);
  expect(surfaces.querySelector(".inst-servo")?.getAttribute("data-state")).toBe("none");
});

test("the HIL plan is stepped by its own commands", async () => {
  station.send({ heartbeat: { ahrs: true } });
  const plan = screen.getByRole("region", { name: "Parámetros del Flight Management System" });
  await userEvent.setup().click(within(plan).getByRole("button", { name: "Previous" }));
  expect(station.asked[0]).toMatchObject({ path: "/api/v1/commands/hil_fms_previous_waypoint" });
});

test("a simulator that is paused is said to be, and none of its values looks live, until it goes on", () => {
  const values = { simulator: { pitch_deg: 5.5 } };
  const looks = (): (string | undefined)[] =>
    ["AHRS", "ADS", "GPS", "Gyros", "AoA, paths", "Mach, VVI, Gload"].map(
      (name) =>
        screen.getByRole("region", { name }).querySelector<HTMLElement>(".ui-badge")?.dataset["state"],
    );
  const { simulator } = aStatus();
  station.status(aStatus({ simulator: { ...simulator, paused: true } }));
  station.send(values);
  expect(screen.queryByText(/^X-Plane está en pausa/)).not.toBeNull();
  expect(new Set(looks())).toEqual(new Set(["stale"]));
  station.status(aStatus());
  station.send(values);
  expect(screen.queryByText(/^X-Plane está en pausa/)).toBeNull();
  expect(new Set(looks())).toEqual(new Set(["live"]));
});
