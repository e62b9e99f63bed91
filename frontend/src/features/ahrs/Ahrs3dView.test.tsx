import { screen, within } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { beforeEach, describe, expect, test } from "vitest";
import { DIRECTIONS } from "../../lib/sphereCover";
import { aStatus } from "../../test/aStatus";
import { Station } from "../../test/station";
import { WORDS } from "../../ui/test/testWords";
import { WordsProvider } from "../../ui/words";
import { Ahrs3dView } from "./Ahrs3dView";

// The view loads this when it opens; load it now, so that it is there at once.
await import("../../scene/attitude/keptStage");

let station: Station;
const user = userEvent.setup();

const manual = { source: "joystick", path: "manual" } as const;

function status(ahrs_test: "off" | "running" = "off") {
  const before = aStatus();
  return aStatus({ hil: { ...before.hil, ...manual }, board: { ...before.board, ahrs_test } });
}

/** Only the tab, without the window around it. */
function open(): void {
  station = new Station(
    <WordsProvider words={WORDS}>
      <Ahrs3dView />
    </WordsProvider>,
  );
  station.greet(status());
  station.send({ heartbeat: { ahrs: true, inertial: true } });
}

function number(name: string): string {
  const row = screen.getByText(name).parentElement;
  return row?.querySelector(".ui-readout-number")?.textContent ?? "";
}

function button(name: string): HTMLElement {
  return screen.getByRole("button", { name });
}

/** The newest message: its key and parameters. */
function said(): unknown {
  return station.page.messages.getState();
}

describe("where the browser has no WebGL", () => {
  beforeEach(open);

  test("the tab says why, and shows the attitude on two instruments", async () => {
    expect(await screen.findByText(/Este navegador no ofrece WebGL/)).toBeDefined();
    station.send({ ahrs: { yaw_deg: 123, pitch_deg: 7, roll_deg: -15 } });
    const adi = screen.getByRole("img", { name: "Indicador de actitud" });
    expect(adi.dataset).toMatchObject({ pitchDeg: "7.0", rollDeg: "-15.0", state: "live" });
    expect(screen.getByRole("img", { name: "Indicador de rumbo" })).toBeDefined();
  });

  test("they show the AHRS test while that runs", async () => {
    await screen.findByText(/Este navegador no ofrece WebGL/);
    station.status(status("running"));
    station.send({ ahrs_test: { yaw_deg: 1, pitch_deg: -4, roll_deg: 5 } });
    const adi = screen.getByRole("img", { name: "Indicador de actitud" });
    expect(adi.dataset).toMatchObject({ pitchDeg: "-4.0", rollDeg: "5.0" });
    expect(number("Pitch")).toBe("-4.0");
  });
});

describe("the alignment", () => {
  beforeEach(open);

  test("takes the present yaw as zero, and is taken back", async () => {
    station.send({ ahrs: { yaw_deg: -20, pitch_deg: 0, roll_deg: 0 } });
    await user.click(button("Alinear"));
    expect(screen.getByText("El rumbo 340.0° es el cero.")).toBeDefined();
    station.send({ ahrs: { yaw_deg: 10.5, pitch_deg: 0, roll_deg: 0 } });
    expect(number("Guiñada desde el cero")).toBe("30.5");
    expect(number("Heading")).toBe("10.5");
    station.send({ ahrs: { yaw_deg: -30, pitch_deg: 0, roll_deg: 0 } });
    expect(number("Guiñada desde el cero")).toBe("-10.0");
    await user.click(button("Quitar alineación"));
    expect(screen.queryByText(/es el cero/)).toBeNull();
  });

  test("is refused with a reason while no yaw is live", () => {
    expect(button("Alinear").getAttribute("aria-disabled")).toBe("true");
    expect(button("Quitar alineación").getAttribute("aria-disabled")).toBe("true");
  });
});

describe("the AHRS test", () => {
  beforeEach(open);

  test("is started after a question, and its proof is said", async () => {
    await user.click(button("Empezar la prueba AHRS"));
    expect(station.asked.filter(({ path }) => path.endsWith("/ahrs-test"))).toEqual([]);
    await user.click(screen.getByRole("button", { name: "Empezar" }));
    const asked = station.asked.find(({ path }) => path === "/api/v1/ahrs-test");
    expect(asked?.method).toBe("POST");
    await asked?.answer({ state: "confirmed", by: "read_back", ms: 320, reason: null });
    expect(JSON.stringify(said())).toContain("@command.ahrs_test_start");
    expect(button("Empezar la prueba AHRS").dataset["state"]).toBe("confirmed");
  });

  test("that begins elsewhere takes no question from under a finger", async () => {
    await user.click(button("Empezar la prueba AHRS"));
    station.status(status("running"));
    await user.click(screen.getByRole("button", { name: "Empezar" }));
    expect(station.asked.at(-1)).toMatchObject({ method: "POST", path: "/api/v1/ahrs-test" });
  });

  test("is ended from here while it runs, and other commands say why they wait", async () => {
    station.status(status("running"));
    station.send({ heartbeat: { ahrs: false } });
    await user.click(button("Terminar la prueba AHRS"));
    expect(station.asked.at(-1)).toMatchObject({ method: "DELETE", path: "/api/v1/ahrs-test" });
    await user.click(screen.getByRole("tab", { name: "Calibración del magnetómetro" }));
    station.send({ heartbeat: { inertial: false } });
    const on = button("Encender");
    const reason = document.getElementById(on.getAttribute("aria-describedby") ?? "");
    expect(reason?.textContent).toBe("La prueba AHRS está en marcha: termínala antes.");
  });

  test.each([
    ["an autopilot is on", { autopilot_hil: true }, "manual"],
    ["the board moves the simulator", {}, "assisted"],
  ] as const)("is not offered while %s", (_, flags, path) => {
    station.status(aStatus({ hil: { ...aStatus().hil, source: "joystick", path } }));
    station.send({ heartbeat: { ahrs: true, ...flags } });
    const start = button("Empezar la prueba AHRS");
    expect(start.getAttribute("aria-disabled")).toBe("true");
    const reason = document.getElementById(start.getAttribute("aria-describedby") ?? "");
    expect(reason?.textContent).toMatch(/está volando/);
  });
});

describe("the calibration of the magnetometer", () => {
  beforeEach(async () => {
    open();
    await user.click(screen.getByRole("tab", { name: "Calibración del magnetómetro" }));
    station.show();
  });

  /** One reading of a field of one, with an offset, towards each of the directions. */
  function turn(some: typeof DIRECTIONS = DIRECTIONS): void {
    for (const [x, y, z] of some) {
      station.send({ inertial: { magx: x + 0.25, magy: y - 0.5, magz: z, accx_m_s2: 0 } });
    }
    station.pass(600);
  }

  test("collects nothing until it is told to, and nothing in a pause", async () => {
    turn(DIRECTIONS.slice(0, 5));
    expect(screen.getByText(/Lecturas: 0\./)).toBeDefined();
    await user.click(button("Empezar a recoger"));
    turn(DIRECTIONS.slice(0, 5));
    await user.click(button("Pausa"));
    turn(DIRECTIONS.slice(5, 20));
    expect(screen.getByText(/Lecturas: 5\./)).toBeDefined();
    expect(screen.getByText("Hacen falta al menos 40 lecturas distintas.")).toBeDefined();
  });

  test("refuses a fit of one side, and says what is missing", async () => {
    station.send({ inertial: { magx: 0, magy: 0, magz: 1 } });
    await user.click(button("Empezar a recoger"));
    turn(DIRECTIONS.filter(([x]) => x > 0.1));
    expect(button("Copiar").getAttribute("aria-disabled")).toBe("true");
    expect(screen.getByText("Falta: apunta la cola al norte y hacia el suelo.")).toBeDefined();
  });

  test("shows the fit, keeps it as a file, and takes a clearing back", async () => {
    station.send({ inertial: { magx: 0, magy: 0, magz: 1 } });
    await user.click(button("Empezar a recoger"));
    turn();
    expect(screen.getByText(/Direcciones vistas: 80 de 80\./)).toBeDefined();
    expect(screen.getByText("Todas las direcciones se han visto.")).toBeDefined();
    const offsets = within(screen.getByRole("table", { name: "Ajuste" }))
      .getAllByRole("row")
      .slice(1)
      .map((row) => within(row).getAllByRole("cell")[0]?.textContent);
    expect(offsets).toEqual(["0.250", "-0.500", "0.000"]);
    await user.click(button("Guardar CSV"));
    expect(station.saved.map(({ name }) => name)).toEqual(["magnetometer.csv"]);
    await user.click(button("Pausa"));
    await user.click(button("Borrar"));
    station.pass(600);
    expect(screen.getByText(/Lecturas: 0\./)).toBeDefined();
    await user.click(button("Deshacer el borrado"));
    station.pass(600);
    expect(screen.getByText(/Direcciones vistas: 80 de 80\./)).toBeDefined();
  });
});
