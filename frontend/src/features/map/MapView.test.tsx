import { act, screen } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { describe, expect, test, vi } from "vitest";
import type { MapLayer } from "../../protocol/mapLayers";
import { FIELD_WISH } from "../../store/fieldWish";
import { choose } from "../../store/settings";
import { Station } from "../../test/station";
import { WORDS } from "../../ui/test/testWords";
import { WordsProvider } from "../../ui/words";
import { MAP_LAYERS } from "./layers/layerList";
import { MapView } from "./MapView";

const FIELD_LAYER: MapLayer = {
  id: "gando",
  kind: "imagery",
  name: "Gando",
  format: "field",
  bytes: 1,
  attribution: "",
  west_deg: -16,
  south_deg: 27,
  east_deg: -15,
  north_deg: 28,
  minimum_zoom: 8,
  maximum_zoom: 14,
  datum: null,
  datum_stated: false,
  geoid_m: null,
  problem: null,
  problem_code: null,
  problem_params: {},
};

// A browser without WebGL, as the page's tests run in one.
const user = userEvent.setup();
let station: Station;

function open(): void {
  station = new Station(
    <WordsProvider words={WORDS}>
      <MapView />
    </WordsProvider>,
  );
  station.greet();
}

type Control = HTMLButtonElement | HTMLInputElement | HTMLSelectElement;

/** By tag and name: a search by role through this long panel takes seconds. */
function control(tag: string, name: string): Control | undefined {
  return [...document.querySelectorAll<Control>(tag)].find(({ ariaLabel, labels, textContent }) =>
    (ariaLabel ?? labels?.[0]?.textContent ?? textContent).startsWith(name),
  );
}

function theControl(tag: string, name: string): Control {
  const found = control(tag, name);
  if (found === undefined) throw new Error(`there is no ${tag} "${name}"`);
  return found;
}

function flatMap(): HTMLElement | null {
  return document.querySelector(".map-flat");
}

function isDisabled(tag: string, name: string): boolean {
  const found = theControl(tag, name);
  return found.disabled || found.ariaDisabled === "true";
}

describe("without WebGL", () => {
  test("the map says why there is no globe, and the 2D map stands in its place", () => {
    open();
    expect(screen.getByText(/no ofrece WebGL 2/).textContent).toContain("En su lugar está el mapa 2D");
    expect(flatMap()?.getAttribute("aria-label")).toContain("Mapa en 2D");
    expect(document.querySelector<HTMLElement>(".map-host")?.hidden).toBe(true);
    expect(theControl("input", "Globo 3D")).toHaveProperty("checked", true);
  });

  test("the graphics are asked for again on demand", async () => {
    open();
    const contexts = vi.spyOn(HTMLCanvasElement.prototype, "getContext");
    await user.click(theControl("button", "Probar otra vez"));
    expect(contexts.mock.calls.map(([kind]) => kind)).toContain("webgl2");
    expect(screen.getByText(/no ofrece WebGL 2/)).toBeTruthy();
  });

  test("what only the globe can show says so, and the rest is as on the globe", () => {
    open();
    expect(isDisabled("input", "Cortina hasta el suelo")).toBe(true);
    expect(isDisabled("select", "Relieve")).toBe(true);
    expect(screen.getAllByText(/Solo en el globo/).length).toBeGreaterThan(0);
    expect(control("input", "Cabina")).toBeUndefined();
    expect(isDisabled("input", "Retícula de coordenadas")).toBe(false);
    expect(isDisabled("button", "Distancia")).toBe(false);
    expect(document.querySelector(".map-plan")).toBeTruthy();
  });
});

describe("the 2D map by choice", () => {
  test("needs no reason, asks for no graphics, and is remembered", async () => {
    open();
    await user.click(theControl("input", "Mapa 2D"));
    expect(screen.queryByText(/no ofrece WebGL 2/)).toBeNull();
    expect(flatMap()?.getAttribute("aria-label")).toContain("Mapa en 2D");
    expect(station.page.settings.getState().choices["map.kind"]).toBe("2d");
  });

  test("is left for the globe again", async () => {
    open();
    act(() => choose(station.page.settings, "map.kind", "2d"));
    expect(screen.queryByText(/no ofrece WebGL 2/)).toBeNull();
    await user.click(theControl("input", "Globo 3D"));
    expect(screen.getByText(/no ofrece WebGL 2/)).toBeTruthy();
  });

  test("follows an aircraft until it is moved by a key, and again when told to", async () => {
    open();
    const follow = theControl("button", "Seguir al avión");
    expect(follow.getAttribute("aria-pressed")).toBe("true");
    flatMap()?.focus();
    await user.keyboard("+");
    expect(follow.getAttribute("aria-pressed")).toBe("true");
    await user.keyboard("{ArrowLeft}");
    expect(follow.getAttribute("aria-pressed")).toBe("false");
    await user.click(follow);
    expect(follow.getAttribute("aria-pressed")).toBe("true");
  });

  test("measures from its middle", async () => {
    open();
    const fromCentre = theControl("button", "Punto en el centro");
    await user.click(fromCentre);
    flatMap()?.focus();
    await user.keyboard("{ArrowRight}");
    await user.click(fromCentre);
    expect(screen.getByText(/· 90°/)).toBeTruthy();
  });
});

test("that roads and imagery come with a field's pack is said until it is answered, and never where there is one", async () => {
  open();
  const layers = station.page.parts.get(MAP_LAYERS).store;
  act(() => layers.setState({ folder: "/maps", layers: [FIELD_LAYER] }));
  expect(control("button", "Preparar un campo…")).toBeUndefined();
  act(() => layers.setState({ folder: "/maps", layers: [] }));
  await user.click(theControl("button", "Preparar un campo…"));
  expect(station.page.parts.get(FIELD_WISH).getState().wish).toEqual({ centre: null });
  expect(control("button", "Preparar un campo…")).toBeUndefined();
});
