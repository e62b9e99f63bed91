import { fireEvent, screen, within } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { describe, expect, test } from "vitest";
import { aStatus, heldBy } from "../test/aStatus";
import { Station } from "../test/station";

const emulated = aStatus({
  board: { ...aStatus().board, emulated: true, before_emulation_url: "serial:///dev/ttyUSB0?baud=115200" },
});

function flying(): Station {
  const station = new Station();
  station.greet();
  return station;
}

describe("the emulation", () => {
  test("stands over every tab for as long as it lasts", () => {
    const station = flying();
    expect(screen.queryByText("EMULACIÓN: valores de ejemplo")).toBeNull();
    station.status(emulated);
    for (const key of ["2", "1"]) {
      fireEvent.keyDown(document.body, { key });
      expect(screen.getByText("EMULACIÓN: valores de ejemplo")).toBeTruthy();
    }
    station.status(aStatus());
    expect(screen.queryByText("EMULACIÓN: valores de ejemplo")).toBeNull();
  });

  test("ends by going back to the line that was open before", () => {
    const station = flying();
    station.status(emulated);
    fireEvent.click(screen.getByText("Terminar"));
    expect(station.asked.at(-1)).toMatchObject({
      method: "PUT",
      path: "/api/v1/links/board",
      body: { url: "serial:///dev/ttyUSB0?baud=115200" },
    });
  });

  test("ends by closing the line where none was open", () => {
    const station = flying();
    station.status(aStatus({ board: { ...emulated.board, before_emulation_url: null } }));
    fireEvent.click(screen.getByText("Terminar"));
    expect(station.asked.at(-1)).toMatchObject({ method: "DELETE", path: "/api/v1/links/board" });
  });
});

describe("the window's title", () => {
  test("tells the state of the board's link, and how many alarms last", () => {
    const station = flying();
    expect(document.title).toBe("conectado · EPF GCS");
    station.status(aStatus({ board: { ...aStatus().board, state: "lost" } }));
    expect(document.title).toBe("perdido · EPF GCS");
    const alarm = {
      id: "heartbeat_lost",
      level: "critical",
      since_s: 1,
      until_s: null,
      text: "",
      params: {},
      acknowledged: false,
      count: 1,
    } as const;
    station.status(aStatus({ alarms: [alarm] }));
    expect(document.title).toBe("(1) conectado · EPF GCS");
    station.status(aStatus({ alarms: [{ ...alarm, until_s: 5 }] }));
    expect(document.title).toBe("conectado · EPF GCS");
    station.breakOff();
    expect(document.title).toBe("desconocido · EPF GCS");
  });
});

describe("leaving", () => {
  const isAsked = (): boolean => !window.dispatchEvent(new Event("beforeunload", { cancelable: true }));

  test("asks whom commands an open board, and nobody else", () => {
    const station = flying();
    expect(isAsked()).toBe(true);
    station.status(aStatus({ control: heldBy("c2", "Ana") }));
    expect(isAsked()).toBe(false);
    station.status(aStatus({ board: { ...aStatus().board, state: "closed" } }));
    expect(isAsked()).toBe(false);
  });
});

test("the about window names the versions, and every package with its licence", async () => {
  const station = flying();
  within(screen.getByLabelText("Menús")).getByText("Ayuda").focus();
  await userEvent.setup().keyboard("{Enter}");
  fireEvent.click(screen.getByText("Acerca de"));
  const about = station.asked.at(-1);
  expect(about).toMatchObject({ method: "GET", path: "/api/v1/about" });
  await about?.answer({
    version: "9.8.7",
    python: "3.11.7",
    platform: "Linux x86_64",
    board: { name: "epf-board", version: "1.0.0", mode: "extended" },
    packages: [{ name: "fastapi", version: "0.1", licence: "MIT" }],
  });
  const text = document.querySelector('[role="dialog"]')?.textContent ?? "";
  for (const part of ["9.8.7", "epf-board 1.0.0, extendido", "fastapi0.1MIT", "ISC", "OFL-1.1"]) {
    expect(text).toContain(part);
  }
  // Its own packages come from the lock file that it was built with.
  const own = screen.getByText("react-dom").closest("tr");
  expect(own?.textContent).toMatch(/^react-dom\d+\.\d+\.\d+MIT$/);
  expect(text).not.toContain("vitest");
});

test("the settings hold at once and are remembered", () => {
  const station = flying();
  fireEvent.keyDown(document.body, { key: "," });
  fireEvent.click(within(screen.getByLabelText("Unidades")).getByLabelText("km"));
  fireEvent.click(screen.getByLabelText("Reducido"));
  const { choices } = station.page.settings.getState();
  expect([choices["unit.distance"], choices["motion"]]).toEqual(["km", "less"]);
  expect(document.documentElement.dataset["motion"]).toBe("less");
});

test("beside the past the alarms say that they are the present's, and no tab counts them", () => {
  const station = flying();
  const alarm = {
    id: "heartbeat_lost",
    level: "critical",
    since_s: 1,
    until_s: 5,
    text: "",
    params: {},
    acknowledged: false,
    count: 1,
  } as const;
  station.status(aStatus({ alarms: [alarm] }));
  const strip = screen.getByRole("region", { name: "Alarmas" });
  expect(strip.textContent).not.toContain("AHORA");
  expect(document.querySelectorAll(".alarms-unseen")).toHaveLength(1);
  station.openFlight("20260131T120000Z", 10);
  expect(strip.textContent).toMatch(/^AHORA.*latido perdido/);
  expect(document.querySelectorAll(".alarms-unseen")).toHaveLength(0);
});

test("a link whose heartbeat stopped is not said to be connected", () => {
  const station = flying();
  station.send({ heartbeat: { autopilot: true } });
  const bar = screen.getByRole("contentinfo");
  expect(bar.textContent).toContain("conectado");
  // Other values still come.
  for (let turn = 0; turn < 8; turn += 1) {
    station.pass(700);
    station.send({ ahrs: { roll_deg: 1 } });
  }
  expect(bar.textContent).not.toContain("conectado");
  expect(bar.textContent).toContain("sin latido");
});
