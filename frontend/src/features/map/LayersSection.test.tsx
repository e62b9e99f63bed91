import userEvent from "@testing-library/user-event";
import { expect, test } from "vitest";
import { type FakeRequest, Station } from "../../test/station";
import { WORDS } from "../../ui/test/testWords";
import { WordsProvider } from "../../ui/words";
import { LayersSection } from "./LayersSection";

const user = userEvent.setup();
const ONLINE = { enabled: false, limit_bytes: 1e9, cached_bytes: 0, sources: [] };
const SOUND = { problem: null, problem_code: null, problem_params: {} };

function terrain(name: string, problem: object = SOUND): object {
  const bounds = { west_deg: -16, south_deg: 27, east_deg: -15, north_deg: 28 };
  const zooms = { minimum_zoom: 0, maximum_zoom: 12 };
  const about = { name, kind: "terrain", format: "hgt", attribution: "", bytes: 2_884_802 };
  const datum = { datum: "orthometric", datum_stated: true, geoid_m: 41.8 };
  return { id: `${name}-hgt`, ...about, ...bounds, ...zooms, ...datum, ...problem };
}

function converting(name: string, percent: number): object {
  const problem = {
    problem: "later",
    problem_code: "map_raster_converting",
    problem_params: { name, percent },
  };
  return terrain(name, problem);
}

function damaged(name: string): object {
  const problem_params = { name, why: "cut off" };
  return terrain(name, { problem: "no", problem_code: "map_file_damaged", problem_params });
}

function open(): Station {
  const station = new Station(
    <WordsProvider words={WORDS}>
      <LayersSection />
    </WordsProvider>,
  );
  station.greet();
  return station;
}

function newest(station: Station, method: string, path: RegExp): FakeRequest {
  const asked = station.asked.filter((one) => one.method === method && path.test(one.path)).at(-1);
  if (asked === undefined) throw new Error(`the page asked nothing with ${method} ${path}`);
  return asked;
}

async function answerLayers(station: Station, layers: readonly object[]): Promise<void> {
  await newest(station, "GET", /map\/online$/).answer(ONLINE);
  await newest(station, "GET", /map\/layers$/).answer({ folder: "/maps", layers });
  station.show();
}

function choices(): string[] {
  return [...document.querySelectorAll("select option")].map(({ textContent }) => textContent);
}

test("heights that cannot be shown are listed with the reason, and are no choice", async () => {
  const station = open();
  await answerLayers(station, [terrain("N27W016"), damaged("N28W016")]);
  expect(choices()).toEqual(["Sin relieve (nivel del mar)", "N27W016"]);
  expect(document.querySelector('[role="alert"]')?.textContent).toContain(
    "N28W016 no se puede leer (cut off)",
  );
});

test("a file of heights put into the folder is followed until it is terrain, and then no more", async () => {
  const station = open();
  await answerLayers(station, [converting("N27W016", 12)]);
  expect(document.querySelector(".map-layer")?.textContent).toContain("convirtiendo en relieve (12 %)");
  const asked = () => station.asked.filter(({ path }) => path.endsWith("/map/layers")).length;
  const before = asked();
  station.pass(2000);
  expect(asked()).toBe(before + 1);
  await answerLayers(station, [terrain("N27W016")]);
  expect(choices()).toContain("N27W016");
  station.pass(60_000);
  expect(asked()).toBe(before + 1);
});

test("terrain can be taken out of the list, and brought back", async () => {
  const station = open();
  await answerLayers(station, [terrain("N27W016")]);
  await user.click(document.querySelector('button[aria-label="Quitar N27W016"]') as HTMLButtonElement);
  await newest(station, "DELETE", /layers\/N27W016-hgt$/).answer({ folder: "/maps", layers: [] });
  expect(choices()).toEqual(["Sin relieve (nivel del mar)"]);
  expect(document.body.textContent).toContain("Recuperar N27W016");
});

test("a set that does not say what its heights count from is asked for, with how much depends on it", async () => {
  const station = open();
  const unsaid = { datum: null, datum_stated: false, geoid_m: 41.8 };
  await answerLayers(station, [terrain("Gando", { ...SOUND, ...unsaid })]);
  const alert = document.querySelector(".map-layer .ui-notice")?.textContent ?? "";
  expect(alert).toContain("Gando no dice desde dónde cuenta sus alturas");
  expect(alert).toContain("en 27.5°, -15.5° difieren en 137 ft");
  const select = [...document.querySelectorAll("select")].at(-1) as HTMLSelectElement;
  await user.selectOptions(select, "ellipsoidal");
  const asked = newest(station, "PUT", /layers\/Gando-hgt\/datum$/);
  expect(asked.body).toEqual({ datum: "ellipsoidal" });
  const chosen = { ...unsaid, datum: "ellipsoidal" };
  await asked.answer({ folder: "/maps", layers: [terrain("Gando", { ...SOUND, ...chosen })] });
  station.show();
  expect(document.body.textContent).not.toContain("no dice desde dónde");
  expect(select.value).toBe("ellipsoidal");
});

test("a set that says it is not asked for", async () => {
  const station = open();
  const said = { datum: "ellipsoidal", datum_stated: true, geoid_m: 41.8 };
  await answerLayers(station, [terrain("Gando", { ...SOUND, ...said })]);
  expect(document.querySelector(".map-layer")?.textContent).toContain(
    "Alturas sobre el elipsoide, según el archivo: la estación las convierte.",
  );
  expect(document.querySelectorAll("select")).toHaveLength(1);
});
