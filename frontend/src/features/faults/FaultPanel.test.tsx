import { screen, within } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { expect, test } from "vitest";
import type { FaultState } from "../../protocol/guards.gen";
import { aStatus } from "../../test/aStatus";
import { aShape } from "../../test/shapes";
import { type FakeRequest, Station } from "../../test/station";
import { Tab } from "../../test/tab";

const user = userEvent.setup();
const NOW_S = aStatus().server_time_s;
const CHOICES = [
  {
    place: "gyro",
    kind: "bias",
    says: "",
    unit: "rad/s",
    usual: 0.03,
    lowest: -10,
    highest: 10,
    usual_s: null,
  },
  { place: "pitot", kind: "bias", says: "", unit: "kt", usual: 5, lowest: -200, highest: 200, usual_s: null },
  { place: "elevator", kind: "weak", says: "", unit: "1", usual: 0.5, lowest: 0, highest: 1, usual_s: null },
  { place: "engine", kind: "out", says: "", unit: "", usual: 0, lowest: 0, highest: 0, usual_s: null },
  { place: "simulator", kind: "pause", says: "", unit: "", usual: 0, lowest: 0, highest: 0, usual_s: 30 },
];
const CALM = { from_deg: 0, speed_kt: 0, turbulence: "none" } as const;

function aFault(parts: Partial<FaultState> = {}): FaultState {
  return aShape("FaultState", {
    id: "a",
    place: "pitot",
    kind: "bias",
    strength: 8,
    unit: "kt",
    begins_s: NOW_S - 5,
    ends_s: NOW_S + 12.4,
    is_on: true,
    ...parts,
  });
}

function flying(faults: readonly FaultState[] | null): ReturnType<typeof aStatus> {
  const { simulator } = aStatus();
  const flown = faults === null ? null : { faults: [...faults], wind: CALM };
  return aStatus({ simulator: { ...simulator, faults: flown } });
}

async function opened(role: string, status = flying([])): Promise<Station> {
  const station = new Station(<Tab name="setup" />);
  station.greet(status);
  const me = { state: "in", kind: "local", role, name: "local", anyone_may_fly: false };
  await station.askedAccess
    .filter(({ path }) => path.endsWith("/me"))
    .at(-1)
    ?.answer(me);
  await asked(station, "GET").at(-1)?.answer({ choices: CHOICES, flown: null });
  return station;
}

function asked(station: Station, method: string): readonly FakeRequest[] {
  return station.asked.filter((one) => one.method === method && one.path.startsWith("/api/v1/faults"));
}

const TITLE = "Instructor: fallos del simulador";
const panel = (): HTMLElement => screen.getByRole("region", { name: TITLE });
const list = (): HTMLSelectElement => within(panel()).getByRole("listbox", { name: "Fallo" });

test("only an owner has the panel, and only with the simulator that takes orders", async () => {
  await opened("operator");
  expect(screen.queryByRole("region", { name: TITLE })).toBeNull();
});

test("with X-Plane there is no panel", async () => {
  await opened("owner", flying(null));
  expect(screen.queryByRole("region", { name: TITLE })).toBeNull();
});

test("a fault is found by its words and begun with what was typed, in the station's unit", async () => {
  const station = await opened("owner");
  await user.type(within(panel()).getByLabelText("Buscar"), "giroscopo");
  expect(
    within(list())
      .getAllByRole("option")
      .map(({ textContent }) => textContent),
  ).toEqual(["Giróscopo: error constante"]);
  await user.selectOptions(list(), "gyro.bias");
  const strength = within(panel()).getByRole("textbox", { name: "Intensidad" });
  expect(strength).toHaveProperty("value", "1.72");
  await user.clear(strength);
  await user.type(strength, "9{Enter}");
  await user.click(within(panel()).getByRole("button", { name: "Empezar este fallo" }));
  const [{ body } = { body: null }] = asked(station, "POST");
  expect(body).toEqual({
    place: "gyro",
    kind: "bias",
    start_s: 0,
    length_s: null,
    strength: expect.closeTo(0.15708, 4),
  });
});

test("a fault without a strength has no field for it, and its usual length stands there", async () => {
  const station = await opened("owner");
  await user.selectOptions(list(), "simulator.pause");
  expect(within(panel()).queryByRole("textbox", { name: "Intensidad" })).toBeNull();
  const length = within(panel()).getByRole("textbox", { name: "Dura" });
  expect(length).toHaveProperty("value", "30");
  await user.click(within(panel()).getByRole("button", { name: "Empezar este fallo" }));
  expect(asked(station, "POST")[0]?.body).toMatchObject({ length_s: 30, strength: null });
});

test("what is flown is listed with its time, ended alone, or all at once", async () => {
  const waiting = aFault({ id: "b", place: "engine", kind: "out", strength: null, unit: "", is_on: false });
  const station = await opened(
    "owner",
    flying([aFault(), { ...waiting, begins_s: NOW_S + 30, ends_s: null }]),
  );
  const rows = within(within(panel()).getByRole("list", { name: "Fallos en curso" })).getAllByRole(
    "listitem",
  );
  expect(rows.map(({ textContent }) => textContent)).toEqual([
    "Velocidad (pitot): error constante, 8 ktquedan 13 sTerminar",
    "Motor: paradaempieza dentro de 30 sTerminar",
  ]);
  await user.click(within(panel()).getByRole("button", { name: "Terminar: Motor: parada" }));
  await user.click(within(panel()).getByRole("button", { name: "Terminar todos los fallos" }));
  expect(asked(station, "DELETE").map(({ path }) => path)).toEqual(["/api/v1/faults/b", "/api/v1/faults"]);
});

test("wind is sent as a whole, with what blows already where nothing else was typed", async () => {
  const station = await opened("owner");
  const speed = within(panel()).getByRole("textbox", { name: "Velocidad" });
  await user.clear(speed);
  await user.type(speed, "15{Enter}");
  await user.selectOptions(within(panel()).getByRole("combobox", { name: "Turbulencia" }), "light");
  await user.click(within(panel()).getByRole("button", { name: "Poner este viento" }));
  expect(asked(station, "PUT")[0]?.body).toEqual({ from_deg: 0, speed_kt: 15, turbulence: "light" });
});

test("a refusal is a sentence at the button", async () => {
  const station = await opened("owner");
  await user.selectOptions(list(), "engine.out");
  await user.click(within(panel()).getByRole("button", { name: "Empezar este fallo" }));
  await asked(station, "POST")[0]?.answer({ code: "faults_silent", detail: "x", params: {} }, 503);
  const button = within(panel()).getByRole("button", { name: "Empezar este fallo" });
  const note = document.getElementById(button.getAttribute("aria-describedby") ?? "");
  expect(note?.textContent).toMatch(/El simulador no responde/);
});
