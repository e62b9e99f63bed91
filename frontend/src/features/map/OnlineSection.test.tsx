import { act, screen, within } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { beforeEach, describe, expect, test } from "vitest";
import { type FakeRequest, Station } from "../../test/station";
import { WORDS } from "../../ui/test/testWords";
import { WordsProvider } from "../../ui/words";
import { MAP_LAYERS } from "./layers/layerList";
import { OnlineSection } from "./OnlineSection";

const user = userEvent.setup({ delay: null });
const PLAIN = {
  id: "ign",
  name: "IGN",
  url: "https://ign.example/{z}/{x}/{y}.png",
  attribution: "© IGN",
  maximum_zoom: 19,
};
const SOURCE = { ...PLAIN, problem: null, problem_code: null, problem_params: {} };
const ONLINE = { enabled: false, limit_bytes: 2e9, cached_bytes: 0, sources: [SOURCE] };

let station: Station;

function newest(method: string, path: RegExp): FakeRequest {
  const asked = station.asked.filter((one) => one.method === method && path.test(one.path)).at(-1);
  if (asked === undefined) throw new Error(`the page asked nothing with ${method} ${path}`);
  return asked;
}

function puts(): readonly unknown[] {
  return station.asked.filter(({ method }) => method === "PUT").map(({ body }) => body);
}

async function read(online: object): Promise<void> {
  act(() => void station.page.parts.get(MAP_LAYERS).read());
  await newest("GET", /map\/online$/).answer(online);
  await newest("GET", /map\/layers$/).answer({ folder: "/maps", layers: [] });
}

function button(name: string | RegExp): HTMLElement {
  return screen.getByRole("button", { name });
}

async function type(name: string, text: string): Promise<void> {
  const field = screen.getByRole("textbox", { name });
  await user.clear(field);
  await user.click(field);
  await user.paste(text);
  await user.tab();
}

beforeEach(() => {
  station = new Station(
    <WordsProvider words={WORDS}>
      <OnlineSection />
    </WordsProvider>,
  );
  station.greet();
});

test("before the station has said so, nobody can tell whether maps of the internet are on", () => {
  expect(document.body.textContent).toContain("No se sabe: la estación aún no lo ha dicho.");
  expect(screen.queryByRole("checkbox")).toBeNull();
});

describe("maps of the internet", () => {
  test("are switched on only after the question that says what that means", async () => {
    await read(ONLINE);
    expect(document.body.textContent).toContain("la estación no pide nada a internet");
    await user.click(screen.getByRole("checkbox", { name: "Usar mapas de internet" }));
    await user.click(button("No usar"));
    expect(puts()).toEqual([]);
    await user.click(screen.getByRole("checkbox", { name: "Usar mapas de internet" }));
    expect(screen.getByRole("alertdialog").textContent).toContain("sabrán qué zona se mira");
    await user.click(button("Usar"));
    const choice = newest("PUT", /map\/online$/);
    expect(choice.body).toEqual({ enabled: true, limit_bytes: 2e9, sources: [PLAIN] });
    await choice.answer({ ...ONLINE, enabled: true });
    expect(document.body.textContent).toContain("decide en Capas cuáles se ven");
  });

  test("are switched off without a question, and a refusal is said", async () => {
    await read({ ...ONLINE, enabled: true });
    await user.click(screen.getByRole("checkbox", { name: "Usar mapas de internet" }));
    const choice = newest("PUT", /map\/online$/);
    expect(choice.body).toMatchObject({ enabled: false });
    await choice.answer({ code: "flight_not_written", detail: "x", params: { why: "disco lleno" } }, 409);
    expect(screen.getByRole("alert").textContent).toContain("disco lleno");
  });

  test("are kept up to the limit that was chosen", async () => {
    await read(ONLINE);
    await type("Límite de lo guardado", "500");
    expect(newest("PUT", /map\/online$/).body).toMatchObject({ limit_bytes: 500_000_000, enabled: false });
  });

  test("that are kept are thrown away only after a question, and there must be some", async () => {
    await read(ONLINE);
    expect(button("Vaciar lo guardado").getAttribute("aria-disabled")).toBe("true");
    await read({ ...ONLINE, cached_bytes: 5_000_000 });
    expect(document.body.textContent).toContain("Guardado: 5.00 MB");
    await user.click(button("Vaciar lo guardado"));
    await user.click(button("Conservar"));
    expect(station.asked.filter(({ method }) => method === "DELETE")).toEqual([]);
    await user.click(button("Vaciar lo guardado"));
    await user.click(button("Vaciar"));
    await newest("DELETE", /online\/cache$/).answer(ONLINE);
    expect(document.body.textContent).toContain("Guardado: 0 B");
  });
});

describe("a source of maps", () => {
  test("that does not answer says why", async () => {
    const problem = {
      problem: "x",
      problem_code: "map_file_damaged",
      problem_params: { name: "IGN", why: "404" },
    };
    await read({ ...ONLINE, sources: [{ ...SOURCE, ...problem }] });
    expect(within(screen.getByRole("list")).getByText(/404/)).toBeTruthy();
  });

  test("is taken out of the list and brought back with one press", async () => {
    await read(ONLINE);
    await user.click(button("Quitar la fuente IGN"));
    const removal = newest("PUT", /map\/online$/);
    expect(removal.body).toMatchObject({ sources: [] });
    await removal.answer({ ...ONLINE, sources: [] });
    await user.click(button("Recuperar la fuente IGN"));
    expect(newest("PUT", /map\/online$/).body).toMatchObject({ sources: [PLAIN] });
    expect(screen.queryByRole("button", { name: "Recuperar la fuente IGN" })).toBeNull();
  });

  test("is added only with a name of its own, a secure address with its places, and its author", async () => {
    await read(ONLINE);
    const add = button("Añadir fuente");
    const why = (): string => {
      const told = add.getAttribute("aria-describedby") ?? "";
      return document.getElementById(told)?.textContent ?? "";
    };
    expect(why()).toContain("Escribe un nombre.");
    await type("Nombre", "Ign");
    expect(why()).toContain("Ya hay una fuente con ese nombre.");
    await type("Nombre", "Mi mapa");
    await type("Dirección", "http://m.example/{z}/{x}/{y}.png");
    expect(why()).toContain("https://");
    await type("Dirección", "https://m.example/{z}/{x}.png");
    expect(why()).toContain("una vez cada uno");
    await type("Dirección", "https://m.example/{z}/{x}/{y}.png");
    expect(why()).toContain("de quién es el mapa");
    await user.click(add);
    expect(puts()).toEqual([]);
    await type("Autoría", "© Yo");
    await type("Zoom máximo", "17");
    await user.click(add);
    expect(newest("PUT", /map\/online$/).body).toMatchObject({
      sources: [
        PLAIN,
        {
          id: "mi-mapa",
          name: "Mi mapa",
          url: "https://m.example/{z}/{x}/{y}.png",
          attribution: "© Yo",
          maximum_zoom: 17,
        },
      ],
    });
    expect(screen.getByRole<HTMLInputElement>("textbox", { name: "Nombre" }).value).toBe("");
  });
});
