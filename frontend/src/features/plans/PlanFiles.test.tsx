import { act, screen, within } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { expect, test } from "vitest";
import type { Waypoint } from "../../lib/plan";
import { aStatus } from "../../test/aStatus";
import { type FakeRequest, Station } from "../../test/station";
import { WORDS } from "../../ui/test/testWords";
import { WordsProvider } from "../../ui/words";
import { PlansView } from "./PlansView";

const user = userEvent.setup();
let station: Station;

const plan: readonly Waypoint[] = [
  { latitude_deg: 27.9515, longitude_deg: -15.3741, altitude_ft: 700, speed_kt: 55 },
  { latitude_deg: 27.9503, longitude_deg: -15.3573, altitude_ft: 1000, speed_kt: 55 },
  { latitude_deg: 27.9239, longitude_deg: -15.3707, altitude_ft: 1000, speed_kt: 60 },
];

function open(status = aStatus()): void {
  station = new Station(
    <WordsProvider words={WORDS}>
      <PlansView map={() => null} />
    </WordsProvider>,
  );
  station.greet(status);
}

/** The view with the plan of the board in its table. */
async function downloaded(): Promise<void> {
  open();
  await user.click(button("Descargar de la placa"));
  await newest("GET", /missions\/flight$/).answer({ plan: "flight", waypoints: plan });
}

function newest(method: string, path: RegExp): FakeRequest {
  const asked = station.asked
    .filter((question) => question.method === method && path.test(question.path))
    .at(-1);
  if (asked === undefined) {
    throw new Error(`the page asked nothing with ${method} ${path}`);
  }
  return asked;
}

/** Sends the plan; the model that flies it before finds nothing. */
async function sendFlown(): Promise<void> {
  await user.click(button("Enviar a la placa"));
  const clean = {
    time_s: 600,
    last: 2,
    ground: "whole",
    heights: [],
    fence: true,
    battery: true,
    findings: [],
  };
  await newest("POST", /missions\/rehearsal$/).answer(clean);
}

function button(name: string | RegExp): HTMLElement {
  return screen.getByRole("button", { name });
}

function cell(field: keyof Waypoint, row: number): HTMLInputElement {
  const found = document.querySelector<HTMLInputElement>(`[data-row="${row}"][data-field="${field}"]`);
  if (found === null) throw new Error(`there is no ${field} in row ${row}`);
  return found;
}

function altitudes(): string[] {
  return [...document.querySelectorAll<HTMLInputElement>('[data-field="altitude_ft"]')].map(
    ({ value }) => value,
  );
}

function state(): string {
  return document.querySelector(".plans-state")?.textContent ?? "";
}

async function write(field: keyof Waypoint, row: number, text: string): Promise<void> {
  await user.clear(cell(field, row));
  await user.type(cell(field, row), text);
}

async function choose(name: string): Promise<void> {
  const input = document.querySelector<HTMLInputElement>('input[type="file"]');
  if (input === null) throw new Error("there is no field for a file");
  await act(() => user.upload(input, new File(["<kml/>"], name)));
}

test("files are read by the gateway into the table, with what had to be supposed, and not sent to the board", async () => {
  open();
  await choose("ruta 1.kml");
  const asked = newest("POST", /import/);
  expect(asked.path).toBe("/api/v1/missions/import?name=ruta%201.kml");
  const heights = [
    { name: "Gando", datum: "ellipsoidal", geoid_m: 43.9 },
    { name: "isla", datum: null, geoid_m: 42.1 },
  ];
  const notes = [{ code: "speed_missing", params: { count: 3, speed_kt: 55 } }];
  await asked.answer({ format: "kml", waypoints: imported(null), notes, heights });
  expect(altitudes()).toEqual(["700", "1000", "1000"]);
  expect(document.body.textContent).toContain("3 waypoints sin velocidad en el archivo: se ha puesto 55 kt.");
  expect(document.body.textContent).toContain("EGM96 las ha convertido en 144 ft, con un error de 3 ft");
  expect(document.body.textContent).toContain(
    "las alturas de isla, de las que nadie ha dicho desde dónde cuentan",
  );
  expect(state()).toBe("plan de la placa aún sin leer");
  expect(station.asked).toHaveLength(1);
});

function imported(origin: object | null): readonly object[] {
  return plan.map((waypoint) => ({ ...waypoint, origin }));
}

test("files with heights above an unknown home ask how high it is, and each altitude says what it came from", async () => {
  open();
  await choose("casa.waypoints");
  const params = { name: "casa.waypoints", place: "@problem.place_line", nth: 2, count: 3, ground_ft: 80 };
  await newest("POST", /import/).answer({ code: "mission_file_no_home", detail: "No.", params }, 422);
  expect(altitudes()).toEqual([]);
  const dialog = within(screen.getByRole("dialog", { name: "¿A qué altura está el punto de partida?" }));
  expect(dialog.getByRole("button", { name: "Leer el plan" }).ariaDisabled).toBe("true");
  await user.click(dialog.getByRole("button", { name: "Terreno en el waypoint 1: 80 ft" }));
  await user.click(dialog.getByRole("button", { name: "Leer con el punto de partida a 80 ft" }));
  const asked = newest("POST", /import/);
  expect(asked.path).toBe("/api/v1/missions/import?name=casa.waypoints&home_ft=80");
  const origin = { frame: "home", height_ft: 620, reference_ft: 80 };
  await asked.answer({ format: "waypoints", waypoints: imported(origin), notes: [], heights: [] });
  const words = "620 ft sobre el punto de partida, que está a 80 ft";
  expect(screen.getAllByText(words)).toHaveLength(3);
  // An altitude that was typed is its own.
  await write("altitude_ft", 0, "750{Enter}");
  expect(screen.getAllByText(words)).toHaveLength(2);
  await user.click(button("Deshacer"));
  expect(screen.getAllByText(words)).toHaveLength(3);
  await sendFlown();
  expect(newest("PUT", /missions\/flight$/).body).toEqual({ waypoints: plan });
});

test("files whose item 0 may be home or a waypoint ask which it is, and then how high home is", async () => {
  open();
  await choose("casa.waypoints");
  const at = { name: "casa.waypoints", place: "@problem.place_line", nth: 2 };
  await newest("POST", /import/).answer(
    { code: "mission_file_home_unclear", detail: "No.", params: at },
    422,
  );
  await user.click(button("El primer waypoint: se vuela"));
  expect(newest("POST", /import/).path).toContain("name=casa.waypoints&first=waypoint");
  const params = { ...at, count: 3, ground_ft: 80 };
  await newest("POST", /import/).answer({ code: "mission_file_no_home", detail: "No.", params }, 422);
  await user.click(button("Terreno en el waypoint 1: 80 ft"));
  await user.click(button("Leer con el punto de partida a 80 ft"));
  expect(newest("POST", /import/).path).toContain("name=casa.waypoints&home_ft=80&first=waypoint");
});

test("files of a flown track ask before they become a plan, and are dropped without an answer", async () => {
  open();
  await choose("vuelo.gpx");
  const params = { name: "vuelo.gpx", points: 3600, waypoints: 40, deviation_m: 11.2 };
  const refusal = { code: "mission_file_track", detail: "No.", params };
  await newest("POST", /import/).answer(refusal, 422);
  const dialog = screen.getByRole("alertdialog");
  expect(dialog.textContent).toContain(
    "3600 puntos. Como plan de 40 waypoints se aparta de ella hasta 12 m.",
  );
  await user.click(within(dialog).getByRole("button", { name: "Cancelar" }));
  expect(station.asked).toHaveLength(1);
  await choose("vuelo.gpx");
  await newest("POST", /import/).answer(refusal, 422);
  await user.click(button("Tomar 40 waypoints"));
  const asked = newest("POST", /import/);
  expect(asked.path).toBe("/api/v1/missions/import?name=vuelo.gpx&thin=true");
  await asked.answer({ format: "gpx", waypoints: imported(null), notes: [], heights: [] });
  expect(altitudes()).toEqual(["700", "1000", "1000"]);
});

test("files that cannot be read say where, and leave the table alone", async () => {
  await downloaded();
  await choose("ruta.csv");
  const params = { name: "ruta.csv", line: 3 };
  await newest("POST", /import/).answer({ code: "mission_file_damaged", detail: "No.", params }, 422);
  expect(screen.getByRole("alert").textContent).toContain("ruta.csv");
  expect(altitudes()).toEqual(["700", "1000", "1000"]);
});

test("files are written by the gateway and given to the person", async () => {
  await downloaded();
  await user.selectOptions(screen.getByRole("combobox", { name: "Formato" }), "gpx");
  await user.click(button("Exportar"));
  const asked = newest("POST", /export/);
  expect(asked).toMatchObject({
    path: "/api/v1/missions/export?format=gpx",
    body: { name: "epf-flight-plan", waypoints: plan },
  });
  await asked.answer({});
  expect(station.saved.map(({ name }) => name)).toEqual(["epf-flight-plan.gpx"]);
});
