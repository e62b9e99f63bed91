import { act, screen, waitFor, within } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { expect, test, vi } from "vitest";
import type { Position } from "../../../lib/geodesy";
import type { Waypoint } from "../../../lib/plan";
import { editPlan, MISSIONS } from "../../../missions/planDrafts";
import type { FlatScene } from "../../../scene/flat/FlatScene";
import { answerMap } from "../../../test/mapWorker";
import { Station } from "../../../test/station";
import { WORDS } from "../../../ui/test/testWords";
import { WordsProvider } from "../../../ui/words";
import { useMapPlan } from "../plan/useMapPlan";
import { FlatContext } from "../scenes/useFlat";
import { CircuitForm } from "./CircuitForm";
import { SurveyForm } from "./SurveyForm";

const user = userEvent.setup();
const CENTRE = { latitude_deg: 27.95, longitude_deg: -15.37 };
const CORNERS = [CENTRE, { latitude_deg: 27.96, longitude_deg: -15.36 }];

/** A map of which only its tools are there. */
function aMap() {
  return {
    measure: vi.fn<(onPlace: ((place: Position) => void) | null) => void>(),
    showArea: vi.fn(),
    showDistance: vi.fn(),
    centre: vi.fn((): Position | null => CENTRE),
  };
}

type FakeMap = ReturnType<typeof aMap>;

let station: Station;

function open(Form: typeof SurveyForm | typeof CircuitForm, scene: FakeMap | null): void {
  function Bench() {
    const plan = useMapPlan("flight");
    return <Form aircraft="flight" plan={plan} />;
  }
  station = new Station(
    <WordsProvider words={WORDS}>
      <FlatContext value={{ isShown: true, scene: scene as unknown as FlatScene | null }}>
        <Bench />
      </FlatContext>
    </WordsProvider>,
  );
  station.greet();
}

function draft(): readonly Waypoint[] {
  return station.page.parts.get(MISSIONS).plans.getState().flight.draft.present;
}

function planHas(waypoints: readonly Waypoint[]): void {
  act(() => editPlan(station.page.parts.get(MISSIONS).plans, "flight", waypoints));
}

const button = (name: string): HTMLElement => screen.getByRole("button", { name });

/** Give the map's click to the form that waits for it. */
function clickOnMap(map: FakeMap, place: Position): void {
  const waiting = map.measure.mock.lastCall?.[0];
  if (waiting == null) throw new Error("nobody waits for a place");
  act(() => waiting(place));
}

async function set(label: string, value: string): Promise<void> {
  const field = screen.getByRole("textbox", { name: label });
  await user.clear(field);
  await user.type(field, `${value}{Enter}`);
}

test("two corners that are clicked make a survey of the lines between them, put into the plan in one step", async () => {
  const map = aMap();
  open(SurveyForm, map);
  expect(button("Sustituir el plan").getAttribute("aria-disabled")).toBe("true");
  await user.click(button("Marcar la zona"));
  for (const corner of CORNERS) clickOnMap(map, corner);
  expect(map.showArea.mock.lastCall?.[0]).toHaveLength(2);
  await set("Altura", "1500");
  await user.click(button("Sustituir el plan"));
  expect(draft().length).toBeGreaterThan(3);
  expect(new Set(draft().map(({ altitude_ft }) => altitude_ft))).toEqual(new Set([1500]));
  const count = draft().length;
  await user.click(button("Añadir al plan"));
  expect(draft()).toHaveLength(2 * count);
});

test("lines further apart are fewer", async () => {
  const map = aMap();
  open(SurveyForm, map);
  await user.click(button("Marcar la zona"));
  for (const corner of CORNERS) clickOnMap(map, corner);
  await user.click(button("Sustituir el plan"));
  const many = draft().length;
  await set("Separación", "600");
  planHas([]);
  await user.click(button("Sustituir el plan"));
  expect(draft().length).toBeLessThan(many);
});

test("a corner is put under the middle of the map, taken back, and all are taken away", async () => {
  const map = aMap();
  open(SurveyForm, map);
  await user.click(button("Esquina en el centro"));
  expect(map.showArea.mock.lastCall?.[0]).toEqual([{ ...CENTRE, label: "" }]);
  await user.click(button("Quitar la última esquina"));
  expect(map.showArea.mock.lastCall?.[0]).toEqual([]);
  await user.click(button("Esquina en el centro"));
  await user.click(button("Borrar la zona"));
  expect(map.showArea.mock.lastCall?.[0]).toEqual([]);
  map.centre.mockReturnValueOnce(null);
  await user.click(button("Esquina en el centro"));
  expect(map.showArea.mock.lastCall?.[0]).toEqual([]);
});

test("without a map no corner can be set, and the buttons say why", () => {
  open(SurveyForm, null);
  expect(button("Marcar la zona").getAttribute("aria-disabled")).toBe("true");
  expect(button("Esquina en el centro").getAttribute("aria-disabled")).toBe("true");
});

test("marking ends with its button, and the outline goes with the form", async () => {
  const map = aMap();
  open(SurveyForm, map);
  await user.click(button("Marcar la zona"));
  await user.click(button("Marcar la zona"));
  expect(map.measure.mock.lastCall?.[0]).toBeNull();
});

test("a circuit of a known runway is put in the place of an edited plan only after a question", async () => {
  open(CircuitForm, aMap());
  planHas([{ latitude_deg: 28, longitude_deg: -15, altitude_ft: 500, speed_kt: 50 }]);
  await user.click(button("Sustituir el plan"));
  expect(draft()).toHaveLength(1);
  const question = await screen.findByRole("alertdialog");
  await user.click(within(question).getByRole("button", { name: /Sustituir/ }));
  expect(draft().length).toBeGreaterThan(4);
});

test("a left circuit lies on the other side of the runway than a right one", async () => {
  open(CircuitForm, aMap());
  await user.click(button("Añadir al plan"));
  const right = draft();
  planHas([]);
  await user.click(screen.getByRole("radio", { name: "A izquierdas" }));
  await user.click(button("Añadir al plan"));
  expect(draft()).toHaveLength(right.length);
  expect(draft()).not.toEqual(right);
});

test("one's own meadow needs its place on the map; its course turns the circuit", async () => {
  open(CircuitForm, aMap());
  await user.selectOptions(screen.getByRole("combobox"), "own");
  expect(button("Sustituir el plan").getAttribute("aria-disabled")).toBe("true");
  await user.click(screen.getByRole("button", { name: "Umbral en el centro del mapa" }));
  await set("Altura sobre el campo", "500");
  await user.click(button("Sustituir el plan"));
  const north = draft();
  expect(north.length).toBeGreaterThan(4);
  planHas([]);
  await set("Rumbo de despegue", "90");
  await user.click(button("Sustituir el plan"));
  expect(draft()).not.toEqual(north);
});

const LEVEL_FIELD = {
  code: "LEXX",
  elevation_ft: 1200,
  runways: [
    {
      ends: ["09", "27"],
      places: [
        { latitude_deg: 28, longitude_deg: -15 },
        { latitude_deg: 28, longitude_deg: -14.99 },
      ],
    },
    { ends: ["18", "36"], places: null },
  ],
};

test("runways around the map's centre take the place of those of the station's own airfield", async () => {
  answerMap({ near: [{ airfield: LEVEL_FIELD, away_m: 10 }] });
  open(CircuitForm, aMap());
  await user.click(button("Pistas alrededor del centro del mapa"));
  const choice = screen.getByRole<HTMLSelectElement>("combobox");
  await waitFor(() => expect(choice.value).toBe("LEXX 09"));
  expect([...choice.options].map(({ text }) => text)).toEqual([
    "LEXX 09",
    "LEXX 27",
    "Pista propia, en el mapa",
  ]);
  await user.click(button("Sustituir el plan"));
  const east = draft();
  expect(Math.min(...east.map(({ altitude_ft }) => altitude_ft))).toBeGreaterThan(1200);
  planHas([]);
  await user.selectOptions(choice, "LEXX 27");
  await user.click(button("Sustituir el plan"));
  expect(draft()).not.toEqual(east);
});

test("where no runway is known, or the map cannot be read, it is said and the choice stays", async () => {
  answerMap({ near: [{ airfield: { ...LEVEL_FIELD, elevation_ft: null }, away_m: 10 }] });
  open(CircuitForm, aMap());
  const before = screen.getByRole<HTMLSelectElement>("combobox").value;
  await user.click(button("Pistas alrededor del centro del mapa"));
  expect(await screen.findByText(/No se conoce ninguna pista/)).toBeTruthy();
  answerMap({ near: "cut off" });
  await user.click(button("Pistas alrededor del centro del mapa"));
  expect(await screen.findByText(/No se pudo leer el mapa/)).toBeTruthy();
  expect(screen.getByRole<HTMLSelectElement>("combobox").value).toBe(before);
});
