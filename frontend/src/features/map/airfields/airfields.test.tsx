import { screen } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { beforeEach, expect, test } from "vitest";
import { SELECTION } from "../../../missions/selection";
import type { AirfieldAt } from "../../../scene/world/cell";
import { answerMap } from "../../../test/mapWorker";
import { Station } from "../../../test/station";
import { WORDS } from "../../../ui/test/testWords";
import { WordsProvider } from "../../../ui/words";
import { AirfieldsSection } from "./AirfieldsSection";
import { AirfieldValues } from "./AirfieldValues";

const GANDO: AirfieldAt = {
  code: "GCLP",
  name: "Gran Canaria",
  latitude_deg: 27.93,
  longitude_deg: -15.39,
  elevation_ft: 78,
  kind: "",
  weight: 4,
  runways: [
    {
      ends: ["03L", "21R"],
      places: [
        { latitude_deg: 27.9192, longitude_deg: -15.3931 },
        { latitude_deg: 27.9451, longitude_deg: -15.3801 },
      ],
      length_ft: 10_171,
      width_ft: 148,
      surface: "asphalt",
      isLit: true,
    },
  ],
  frequencies: [{ type: "TWR", description: "Canarias", mhz: 118.3 }],
};

let answers: Record<string, unknown>;

beforeEach(() => {
  answers = { airfield: [{ airfield: GANDO }], near: [{ airfield: GANDO }] };
  answerMap(answers);
});

function card(airfield: Partial<AirfieldAt> = {}): void {
  answers["airfield"] = [{ airfield: { ...GANDO, ...airfield } }];
  const station = new Station(
    <WordsProvider words={WORDS}>
      <AirfieldValues code="GCLP" latitude_deg={27.93} longitude_deg={-15.39} />
    </WordsProvider>,
  );
  station.greet();
}

test("an airfield's card has its name, elevation, runways with their surface and light, and frequencies", async () => {
  card();
  expect(screen.getByText("Leyendo…")).toBeTruthy();
  expect(await screen.findByText("Gran Canaria")).toBeTruthy();
  expect(screen.getByText(/^03L\/21R · .* · asfalto · iluminada$/)).toBeTruthy();
  expect(screen.getByText("118.300 MHz")).toBeTruthy();
  expect(screen.getByText(/sin garantía/)).toBeTruthy();
});

test("what the source does not give is said, and nothing is made up", async () => {
  card({ elevation_ft: null, runways: [], frequencies: null });
  expect(await screen.findByText("La fuente no da pistas.")).toBeTruthy();
  expect(screen.getByText("La fuente no da frecuencias.")).toBeTruthy();
  expect(screen.getByText("Elevación").nextElementSibling?.textContent).not.toMatch(/\d/);
});

test("a runway without a length has that between its ends, and an unknown surface has no word", async () => {
  const [runway] = GANDO.runways ?? [];
  if (runway === undefined) throw new Error("the example has a runway");
  card({ runways: [{ ...runway, length_ft: null, surface: "moss", isLit: false }] as AirfieldAt["runways"] });
  const text = (await screen.findByText(/^03L\/21R/)).textContent;
  expect(text).toMatch(/^03L\/21R · [\d.,]+ \S+$/);
});

test("a map that cannot be read is said on the card", async () => {
  answers["airfield"] = "the file is cut";
  const station = new Station(
    <WordsProvider words={WORDS}>
      <AirfieldValues code="GCLP" latitude_deg={27.93} longitude_deg={-15.39} />
    </WordsProvider>,
  );
  station.greet();
  expect(await screen.findByText("No se ha podido leer el mapa de la estación.")).toBeTruthy();
});

function list(): Station {
  const station = new Station(
    <WordsProvider words={WORDS}>
      <AirfieldsSection />
    </WordsProvider>,
  );
  station.greet();
  return station;
}

test("the nearest airfields are buttons with distance and bearing; a press chooses one, the next leaves it", async () => {
  const user = userEvent.setup();
  const station = list();
  const button = await screen.findByRole("button", { name: /^GCLP · .*°/ });
  await user.click(button);
  expect(station.page.parts.get(SELECTION).getState().thing).toMatchObject({
    kind: "airfield",
    code: "GCLP",
  });
  await user.click(button);
  expect(station.page.parts.get(SELECTION).getState().thing).toBeNull();
});

test("no airfield near is one sentence, and so is a map that cannot be read", async () => {
  answers["near"] = [];
  list();
  expect(await screen.findByText("No se conoce ninguno cerca.")).toBeTruthy();
});

test("a list that cannot be read says so", async () => {
  answers["near"] = "the file is cut";
  list();
  expect(await screen.findByText("No se ha podido leer el mapa de la estación.")).toBeTruthy();
});
