import { act, screen } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { useEffect, useMemo, useState } from "react";
import { beforeEach, expect, test, vi } from "vitest";
import type { Status } from "../../../protocol/contract";
import type { SurroundingsChoice } from "../../../protocol/guards.gen";
import type { FlatScene } from "../../../scene/flat/FlatScene";
import { choose } from "../../../store/settings";
import { anAround, aStatus } from "../../../test/aStatus";
import { type FakeRequest, Station } from "../../../test/station";
import { WORDS } from "../../../ui/test/testWords";
import { WordsProvider } from "../../../ui/words";
import { FlatMap } from "../flat/FlatMap";
import { FlatContext } from "../scenes/useFlat";
import { SurroundingsOnMap, warnedTrack } from "./SurroundingsOnMap";
import { SurroundingsSection } from "./SurroundingsSection";
import { SURROUNDINGS } from "./surroundings";

// The flat map, whose middle is at 0, 0 where a document has no layout.
const user = userEvent.setup();
const OFF: SurroundingsChoice = {
  terrain_on: false,
  margin_ft: 150,
  fence_on: false,
  corners: [],
  ceiling_ft: null,
  fence_margin_ft: 100,
};
const CORNERS = [
  { latitude_deg: 27.93, longitude_deg: -15.38 },
  { latitude_deg: 27.95, longitude_deg: -15.38 },
  { latitude_deg: 27.95, longitude_deg: -15.36 },
];
let station: Station;
let drawnOn: FlatScene | null = null;

function Both() {
  const [scene, setScene] = useState<FlatScene | null>(null);
  useEffect(() => {
    drawnOn = scene;
  }, [scene]);
  const flat = useMemo(() => ({ isShown: true, scene }), [scene]);
  return (
    <WordsProvider words={WORDS}>
      <FlatContext value={flat}>
        <FlatMap onScene={setScene} />
        <SurroundingsOnMap />
        <SurroundingsSection />
      </FlatContext>
    </WordsProvider>
  );
}

beforeEach(() => {
  station = new Station(<Both />);
  HTMLCanvasElement.prototype.setPointerCapture = () => undefined;
  act(() => choose(station.page.settings, "map.fold.around", "no"));
  station.greet();
});

function newest(method: string): FakeRequest {
  const asked = station.asked
    .filter((one) => one.method === method && one.path.endsWith("/surroundings"))
    .at(-1);
  if (asked === undefined) throw new Error(`nothing was asked with ${method}`);
  return asked;
}

function newestAt(method: string, path: string): FakeRequest {
  const asked = station.asked.filter((one) => one.method === method && one.path.endsWith(path)).at(-1);
  if (asked === undefined) throw new Error(`${path} was not asked`);
  return asked;
}

async function given(parts: Partial<SurroundingsChoice> = {}): Promise<void> {
  await newest("GET").answer({ ...OFF, ...parts });
  station.show();
}

function drawn(): readonly { latitude_deg: number; longitude_deg: number }[] {
  return station.page.parts.get(SURROUNDINGS).store.getState().corners.present;
}

function pointer(type: string, x: number, y: number): void {
  const event = new PointerEvent(type, {
    pointerId: 1,
    isPrimary: true,
    button: 0,
    pointerType: "mouse",
    bubbles: true,
  });
  Object.defineProperties(event, { offsetX: { value: x }, offsetY: { value: y } });
  act(() => void document.querySelector(".map-flat canvas")?.dispatchEvent(event));
}

function press(x: number, y: number): void {
  pointer("pointerdown", x, y);
  pointer("pointerup", x, y);
  station.show();
}

const button = (name: string): HTMLElement => screen.getByRole("button", { name });
const box = (name: RegExp): HTMLInputElement => screen.getByRole("checkbox", { name });

test("nothing warns until it is chosen, and the choice goes to the station for everybody", async () => {
  await given();
  expect([box(/^Avisar del terreno/).checked, box(/^Avisar de la valla 30 s/).checked]).toEqual([
    false,
    false,
  ]);
  await user.click(box(/^Avisar del terreno/));
  expect(newest("PUT").body).toEqual({ ...OFF, terrain_on: true });
  await newest("PUT").answer({ ...OFF, terrain_on: true });
  expect(box(/^Avisar del terreno/).checked).toBe(true);
  // A fence without corners and ceiling cannot be watched.
  await user.click(box(/^Avisar de la valla 30 s/));
  expect(newest("PUT").body).toEqual({ ...OFF, terrain_on: true });
});

test("each press puts a corner, undo takes it back, and the fence is the station's once it is saved", async () => {
  await given();
  await user.click(button("Marcar esquinas"));
  press(0, 0);
  press(100, 0);
  expect(button("Guardar la valla").ariaDisabled).toBe("true");
  press(100, 100);
  press(0, 100);
  expect(drawn()).toHaveLength(4);
  await user.click(button("Deshacer en la valla"));
  expect(drawn()).toHaveLength(3);
  await user.click(button("Rehacer en la valla"));
  await user.keyboard("{Backspace}");
  expect(drawn()).toHaveLength(3);
  expect(screen.getByText(/Sin guardar/)).toBeTruthy();
  await user.click(button("Guardar la valla"));
  const body = newest("PUT").body as SurroundingsChoice;
  expect(body.corners).toEqual(drawn());
  expect(body.fence_on).toBe(false);
  await newest("PUT").answer(body);
  expect(screen.queryByText(/Sin guardar/)).toBeNull();
});

test("a corner is dragged to where it is let go, and Escape leaves it where it was", async () => {
  await given({ corners: CORNERS });
  press(0, 0);
  const before = drawn();
  pointer("pointerdown", 0, 0);
  pointer("pointermove", 40, 0);
  pointer("pointermove", 80, 0);
  pointer("pointerup", 80, 0);
  expect(drawn()[0]?.longitude_deg).toBeGreaterThan((before[0]?.longitude_deg ?? 0) + 0.001);
  expect(drawn().slice(1)).toEqual(before.slice(1));
  await user.click(button("Deshacer en la valla"));
  expect(drawn()).toEqual(before);
});

test("a fence that somebody else saves is followed, but not over what was drawn here and not saved", async () => {
  await given();
  const told = { type: "event", event: "surroundings", t_s: 1_700_000_000, data: {} } as const;
  act(() => station.deliver(told));
  await newest("GET").answer({ ...OFF, corners: CORNERS });
  expect(drawn()).toEqual(CORNERS);
  await user.click(button("Quitar todas las esquinas"));
  act(() => station.deliver(told));
  await newest("GET").answer({ ...OFF, corners: CORNERS.toReversed() });
  expect(drawn()).toEqual([]);
});

test("a corner is typed, put between two others, and taken away by its number", async () => {
  await given({ corners: CORNERS });
  await user.selectOptions(screen.getByLabelText("Esquina"), "Esquina 2");
  const place = screen.getByLabelText("Coordenadas");
  await user.clear(place);
  await user.type(place, "27.96, -15.39{Enter}");
  expect(drawn()[1]).toEqual({ latitude_deg: 27.96, longitude_deg: -15.39 });
  await user.click(button("Insertar tras la esquina 2"));
  expect(drawn()).toHaveLength(4);
  expect(drawn()[2]?.latitude_deg).toBeCloseTo(27.955, 3);
  await user.click(button("Quitar la esquina 3"));
  expect(drawn()).toHaveLength(3);
  expect(drawn()[2]).toEqual(CORNERS[2]);
  expect(screen.getByText(/Sin guardar/)).toBeTruthy();
});

test("a file's fence is drawn and not yet watched, what it could not bring is said, and Undo takes it back", async () => {
  await given({ corners: CORNERS });
  const there = CORNERS.map(({ latitude_deg }) => ({ latitude_deg, longitude_deg: 5 }));
  const choose = async (file: File): Promise<void> =>
    user.upload(
      document.querySelector<HTMLInputElement>("input[accept^='.kml,.kmz,.plan']") as HTMLElement,
      file,
    );
  await choose(new File(["x"], "campo uno.plan"));
  const asked = newestAt("POST", "/surroundings/fence/import?name=campo%20uno.plan");
  await asked.answer({
    format: "plan",
    corners: there,
    ceiling_ft: 1200,
    notes: [{ code: "exclusions_skipped", params: { count: 2 } }],
  });
  expect(drawn()).toEqual(there);
  expect(screen.getByText(/campo uno.plan: esquinas leídas: 3/)).toBeTruthy();
  expect(screen.getByText(/Zonas prohibidas del archivo .*: 2/)).toBeTruthy();
  expect(screen.getByText(/techo de 1200 ft/)).toBeTruthy();
  expect(screen.getByText(/Sin guardar/)).toBeTruthy();
  expect(station.asked.filter(({ method }) => method === "PUT")).toEqual([]);
  expect(screen.queryByRole("link", { name: "Guardar como KML" })).toBeNull();
  await user.click(button("Deshacer en la valla"));
  expect(drawn()).toEqual(CORNERS);
  const link = screen.getByRole("link", { name: "Guardar como .plan" });
  expect(link.getAttribute("href")).toBe("/api/v1/surroundings/fence?format=plan");
  await choose(new File(["x"], "foto.kml"));
  await newestAt("POST", "/surroundings/fence/import?name=foto.kml").answer(
    { code: "fence_file_unknown", detail: "x", params: { name: "foto.kml" } },
    422,
  );
  expect(
    screen.getByText(
      "foto.kml no es una valla que se pueda leer: KML, KMZ, .plan, un .waypoints con elementos de valla, o líneas de latitud y longitud. Elige otro archivo.",
    ),
  ).toBeTruthy();
  expect(drawn()).toEqual(CORNERS);
});

test("a fence that crosses itself says at which sides, and is saved once a corner was moved", async () => {
  await given({ corners: CORNERS });
  const bow = [
    { latitude_deg: 27.93, longitude_deg: -15.38 },
    { latitude_deg: 27.95, longitude_deg: -15.36 },
    { latitude_deg: 27.95, longitude_deg: -15.38 },
    { latitude_deg: 27.93, longitude_deg: -15.36 },
  ];
  act(() => station.page.parts.get(SURROUNDINGS).edit(bow));
  expect(screen.getByRole("alert").textContent).toContain("Los lados 1 y 3 se cruzan");
  expect(button("Guardar la valla").ariaDisabled).toBe("true");
  act(() => station.page.parts.get(SURROUNDINGS).edit(bow.toSpliced(3, 1)));
  expect(screen.queryByText(/se cruzan/)).toBeNull();
  expect(button("Guardar la valla").ariaDisabled).not.toBe("true");
});

test("who may only look sees the fence and changes nothing", async () => {
  await given({ corners: CORNERS, terrain_on: true });
  act(() => station.page.admission.setState({ role: "viewer" }));
  await user.click(box(/^Avisar del terreno/));
  pointer("pointerdown", 0, 0);
  pointer("pointermove", 80, 0);
  pointer("pointerup", 80, 0);
  expect(station.asked.filter(({ method }) => method === "PUT")).toEqual([]);
  expect(drawn()).toEqual(CORNERS);
  expect(button("Marcar esquinas").ariaDisabled).toBe("true");
});

test("the panel says the height above the ground and what is ahead, or why it sees nothing", async () => {
  await given();
  expect(screen.getByText(/sin posición actual/)).toBeTruthy();
  act(() =>
    station.status(aStatus({ surroundings: { flight: anAround({ blind: "no_heights" }), hil: anAround() } })),
  );
  expect(screen.getByText(/Aquí no hay alturas: la estación no tiene/)).toBeTruthy();
  const ahead = {
    what: "terrain",
    in_s: 28.4,
    latitude_deg: 28,
    longitude_deg: -15,
    altitude_ft: 900,
  } as const;
  const flight = anAround({ blind: null, ground_ft: 400, height_ft: 512, terrain: ahead });
  act(() => station.status(aStatus({ surroundings: { flight, hil: anAround() } })));
  expect(screen.getByText(/512 ft sobre el terreno/)).toBeTruthy();
  expect(screen.getByText("Terreno en 28 s")).toBeTruthy();
  // Without the gateway nothing of it is live.
  station.breakOff();
  await expect.poll(() => screen.queryByText("Terreno en 28 s")).toBeNull();
});

test("the map is drawn again for a warning and for its end, and not for each word of a quiet station", async () => {
  await given();
  if (drawnOn === null) throw new Error("there is no map");
  const warn = vi.spyOn(drawnOn.fence, "warn");
  const saying = (flight: Status["surroundings"]["flight"]): void =>
    act(() => station.status(aStatus({ surroundings: { flight, hil: anAround() } })));
  saying(anAround());
  saying(anAround({ blind: null, height_ft: 512 }));
  expect(warn).not.toHaveBeenCalled();
  const fence = { what: "fence", in_s: 4, latitude_deg: 3, longitude_deg: 4, altitude_ft: 0 } as const;
  saying(anAround({ path: [{ latitude_deg: 28, longitude_deg: -15 }], fence }));
  expect(warn).toHaveBeenCalledTimes(1);
  saying(anAround());
  saying(anAround());
  expect(warn).toHaveBeenCalledTimes(2);
  expect(warn).toHaveBeenLastCalledWith([]);
});

test("the track that is warned of ends at what it leads to first", () => {
  const path = [0, 1, 2, 3].map((step) => ({ latitude_deg: 28, longitude_deg: -15 + step / 100 }));
  const say = (what: string, seconds: number): string => `${what} ${seconds}`;
  expect(warnedTrack(anAround({ path }), say)).toEqual([]);
  const terrain = { what: "terrain", in_s: 6, latitude_deg: 1, longitude_deg: 2, altitude_ft: 1000 } as const;
  const fence = { what: "fence", in_s: 4, latitude_deg: 3, longitude_deg: 4, altitude_ft: 0 } as const;
  const track = warnedTrack(anAround({ path, terrain, fence }), say);
  expect(track.map(({ longitude_deg }) => longitude_deg)).toEqual([-15, -14.99, 4]);
  expect(track.at(-1)?.label).toBe("fence 4");
});
