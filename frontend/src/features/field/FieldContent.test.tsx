import { act, screen, within } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { expect, test } from "vitest";
import { FIELD_WISH } from "../../store/fieldWish";
import { type FakeRequest, Station } from "../../test/station";

const user = userEvent.setup();
const FIELDS = "/api/v1/map/fields";
const SOURCE = {
  id: "pnoa",
  kind: "imagery",
  name: "PNOA",
  url: "https://example.org/{z}/{x}/{y}.jpg",
  attribution: "© IGN",
  terms: "CC BY 4.0.",
  terms_url: "https://example.org/terms",
  maximum_zoom: 19,
  usual_zoom: 16,
};
const FIELD = {
  id: "0123456789ab",
  name: "Gando",
  state: "running",
  doing: "fetching",
  percent: null,
  layer: null,
  sources: [{ kind: "imagery", name: "PNOA" }],
  tiles: 25,
  tiles_total: 100,
  tiles_missing: 0,
  bytes: 500_000,
  bytes_total: 2_000_000,
  bytes_per_s: 100_000,
  left_s: 61,
  retries: 0,
  waits_s: null,
  problem: null,
  problem_code: null,
  problem_params: {},
};
const ESTIMATE = {
  levels: [{ kind: "imagery", zoom: 16, tiles: 900, bytes: 16_000_000 }],
  tiles: 900,
  bytes: 16_000_000,
  made_bytes: 0,
  free_bytes: 5_000_000_000,
};

function newest(station: Station, method: string, path: string): FakeRequest {
  const found = station.asked.filter((one) => one.method === method && one.path === path).at(-1);
  if (found === undefined) throw new Error(`nothing was asked of ${path}`);
  return found;
}

async function opened(fields: readonly object[], sources: readonly object[] = [SOURCE]): Promise<Station> {
  const station = new Station();
  station.greet();
  await user.click(screen.getByRole("menuitem", { name: "Ver" }));
  await user.click(await screen.findByRole("menuitem", { name: "Preparar un campo…" }));
  await screen.findByRole("dialog", { name: "Preparar un campo" });
  await newest(station, "GET", FIELDS).answer({ fields, sources });
  return station;
}

test("nothing is asked of a source before it is chosen, its terms are accepted and the button is pressed", async () => {
  const station = await opened([]);
  const begin = await screen.findByRole("button", { name: /^Preparar el campo/ });
  await user.click(begin);
  expect(station.asked.filter(({ path }) => path.startsWith(`${FIELDS}/`))).toEqual([]);
  await user.type(screen.getByRole("textbox", { name: "Nombre" }), "Gando{Enter}");
  await user.selectOptions(screen.getByRole("combobox", { name: "Fuente de Imágenes" }), "PNOA");
  // Without an aircraft and a plan nobody knows where: nothing is looked at until somebody says it.
  expect(station.asked.some(({ path }) => path === `${FIELDS}/estimate`)).toBe(false);
  await user.type(screen.getByRole("textbox", { name: "Coordenadas" }), "27.93, -15.38{Enter}");
  expect(screen.getByRole("link", { name: "Condiciones completas" }).getAttribute("href")).toBe(
    SOURCE.terms_url,
  );
  await newest(station, "POST", `${FIELDS}/estimate`).answer(ESTIMATE);
  expect(await screen.findByText(/^Unas 900 piezas/)).toBeTruthy();
  await user.click(begin);
  expect(station.asked.some(({ method, path }) => method === "POST" && path === FIELDS)).toBe(false);
  await user.click(screen.getByRole("checkbox", { name: /condiciones/ }));
  await user.click(begin);
  const { body } = newest(station, "POST", FIELDS);
  expect(body).toMatchObject({
    name: "Gando",
    points: [{ latitude_deg: 27.93, longitude_deg: -15.38 }],
    radius_m: 10_000,
    accepts_terms: true,
    parts: [{ kind: "imagery", url: SOURCE.url, minimum_zoom: 8, maximum_zoom: 16 }],
  });
});

test("other sources have other terms: they are accepted again", async () => {
  await opened([]);
  await user.type(screen.getByRole("textbox", { name: "Nombre" }), "Gando{Enter}");
  await user.type(screen.getByRole("textbox", { name: "Coordenadas" }), "27.93, -15.38{Enter}");
  const choice = screen.getByRole("combobox", { name: "Fuente de Imágenes" });
  await user.selectOptions(choice, "PNOA");
  await user.click(screen.getByRole("checkbox", { name: /condiciones/ }));
  await user.selectOptions(choice, "Otra dirección…");
  await user.type(
    screen.getByRole("textbox", { name: "Dirección de Imágenes" }),
    "https://other.example/{{z}/{{x}/{{y}{Enter}",
  );
  expect(screen.getByRole<HTMLInputElement>("checkbox", { name: /condiciones/ }).checked).toBe(false);
});

test("a field under way says how far it is, and why nothing comes; it can be paused", async () => {
  const station = await opened([FIELD]);
  const row = within(await screen.findByRole("list", { name: "Campos en preparación" }));
  expect(row.getByText(/25 de 100 piezas/).textContent).toContain("quedan unos 2 min");
  const silent = {
    problem: "silent",
    problem_code: "field_source_silent",
    problem_params: { name: "PNOA", why: "429" },
  };
  const data = { ...FIELD, ...silent, waits_s: 12.2 };
  station.deliver({ type: "event", event: "map_field", t_s: 1, data });
  expect((await row.findByText(/PNOA no contesta ahora/)).textContent).toContain("Otro intento en 13 s.");
  await user.click(row.getByRole("button", { name: /^Pausar/ }));
  await newest(station, "POST", `${FIELDS}/${FIELD.id}/pause`).answer({ ...FIELD, state: "paused" });
  expect(await row.findByRole("button", { name: /^Continuar/ })).toBeTruthy();
});

test("a place that was pointed at on the map opens the window around it, and the next window forgets it", async () => {
  const station = new Station();
  station.greet();
  const wishes = station.page.parts.get(FIELD_WISH);
  act(() => wishes.setState({ wish: { centre: { latitude_deg: 27.93, longitude_deg: -15.42 } } }));
  await screen.findByRole("dialog", { name: "Preparar un campo" });
  await newest(station, "GET", FIELDS).answer({ fields: [], sources: [SOURCE] });
  const place = await screen.findByRole<HTMLInputElement>("textbox", { name: "Coordenadas" });
  expect(place.value).toBe("27.930000 -15.420000");
  await user.keyboard("{Escape}");
  expect(wishes.getState().wish).toBeNull();
});

test("the set that is ready for a place says what it takes before it is chosen, and one press chooses it", async () => {
  const world = { ...SOURCE, id: "terrain-tiles", kind: "heights", name: "Terrain Tiles", usual_zoom: 12 };
  const station = await opened([], [SOURCE, world]);
  await user.type(await screen.findByRole("textbox", { name: "Coordenadas" }), "27.93, -15.38{Enter}");
  await newest(station, "POST", `${FIELDS}/estimate`).answer(ESTIMATE);
  expect(await screen.findByText(/^Unas 900 piezas/)).toBeTruthy();
  await user.click(screen.getByRole("button", { name: "Elegir el juego listo para este sitio" }));
  expect(newest(station, "POST", `${FIELDS}/estimate`).body).toMatchObject({
    name: "27.930, -15.380",
    parts: [{ kind: "heights", name: "Terrain Tiles", maximum_zoom: 12 }],
  });
  expect(screen.queryByRole("button", { name: "Elegir el juego listo para este sitio" })).toBeNull();
});
