import { act, screen, within } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { useState } from "react";
import { describe, expect, test } from "vitest";
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
const legacy = aStatus({
  board: {
    ...aStatus().board,
    mode: "legacy",
    features: { acknowledgements: false, store: false, sources: false, missions: false },
  },
});

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

describe("a download", () => {
  test("happens only when it is asked for: opening the tab sends nothing", () => {
    open();
    expect(station.asked).toEqual([]);
    expect(document.body.textContent).toContain("El plan está vacío");
  });

  test("fills the table, with the way from each point to the next", async () => {
    await downloaded();
    const rows = screen.getAllByRole("row").slice(1);
    expect(rows).toHaveLength(3);
    expect(cell("latitude_deg", 0).value).toBe("27.951500");
    expect(
      within(rows[0] ?? document.body)
        .getAllByRole("cell")
        .map(({ textContent }) => textContent)
        .slice(4),
    ).toEqual(["1656", "94.6", "+3.2"]);
    expect(rows[2]?.textContent).toBe("3–––");
    expect(state()).toBe("igual que en la placa");
  });

  test("that fails keeps what is there and says why", async () => {
    await downloaded();
    await user.click(button("Descargar de la placa"));
    await newest("GET", /flight$/).answer({ code: "mission_not_read", detail: "No.", params: {} }, 502);
    expect(altitudes()).toEqual(["700", "1000", "1000"]);
    expect(screen.getByRole("alert").textContent).toContain("La placa no ha enviado el plan entero");
  });

  test("over edits that were not sent asks first", async () => {
    await downloaded();
    await write("altitude_ft", 0, "800{Enter}");
    await user.click(button("Descargar de la placa"));
    expect(station.asked).toHaveLength(1);
    await user.click(within(screen.getByRole("alertdialog")).getByRole("button", { name: "Conservar" }));
    expect(station.asked).toHaveLength(1);
    await user.click(button("Descargar de la placa"));
    await user.click(within(screen.getByRole("alertdialog")).getByRole("button", { name: "Sustituir" }));
    expect(station.asked).toHaveLength(2);
  });
});

describe("an edit", () => {
  test("is finished by Enter, which goes down the column, and taken back by Escape", async () => {
    await downloaded();
    await write("altitude_ft", 0, "850{Enter}");
    expect(document.activeElement).toBe(cell("altitude_ft", 1));
    await user.keyboard("999{Escape}");
    expect(altitudes()).toEqual(["850", "1000", "1000"]);
    expect(state()).toBe("distinto del de la placa");
    expect(station.asked).toHaveLength(1);
  });

  test("is undone and redone by keys and buttons", async () => {
    await downloaded();
    await write("altitude_ft", 0, "850{Enter}");
    await user.keyboard("{Control>}z{/Control}");
    expect(altitudes()).toEqual(["700", "1000", "1000"]);
    await user.click(button("Rehacer"));
    expect(altitudes()).toEqual(["850", "1000", "1000"]);
  });

  test("of what is no number changes nothing and says so", async () => {
    await downloaded();
    await write("altitude_ft", 0, "high{Enter}");
    expect(cell("altitude_ft", 0).getAttribute("aria-invalid")).toBe("true");
    await user.tab();
    expect(altitudes()).toEqual(["700", "1000", "1000"]);
  });

  test("with two readings asks in the cell, sends no plan meanwhile, and takes the answer", async () => {
    await downloaded();
    await write("altitude_ft", 0, "1.200");
    await user.click(button("Enviar a la placa"));
    expect(altitudes()).toEqual(["700", "1000", "1000"]);
    expect(document.querySelector(".plans-complaint")?.textContent).toContain("w-which");
    expect(button("Enviar a la placa").getAttribute("aria-disabled")).toBe("true");
    expect(station.asked.filter(({ method }) => method !== "GET")).toEqual([]);
    await user.click(button("1200"));
    expect(altitudes()).toEqual(["1200", "1000", "1000"]);
    await sendFlown();
    expect(newest("PUT", /flight$/).body).toMatchObject({ waypoints: [{ altitude_ft: 1200 }, {}, {}] });
  });

  test("in another unit is kept in feet", async () => {
    await downloaded();
    act(() => {
      station.page.settings.setState(({ choices }) => ({ choices: { ...choices, "unit.altitude": "m" } }));
    });
    expect(altitudes()).toEqual(["213.4", "304.8", "304.8"]);
    await write("altitude_ft", 0, "304.8{Enter}");
    await sendFlown();
    expect(newest("PUT", /flight$/).body).toMatchObject({ waypoints: [{ altitude_ft: 1000 }, {}, {}] });
  });

  test("moves, inserts and removes rows by keys, with the cursor in the row", async () => {
    await downloaded();
    await user.click(cell("altitude_ft", 0));
    await user.keyboard("{Alt>}{ArrowDown}{/Alt}");
    expect(altitudes()).toEqual(["1000", "700", "1000"]);
    expect(document.activeElement).toBe(cell("altitude_ft", 1));
    await user.keyboard("{Alt>}{Insert}{/Alt}");
    expect(altitudes()).toEqual(["1000", "700", "850", "1000"]);
    await user.keyboard("{Alt>}{Delete}{/Alt}");
    expect(altitudes()).toEqual(["1000", "700", "1000"]);
  });

  test("does the same by buttons", async () => {
    await downloaded();
    expect(
      screen.getByRole("button", { name: "Quitar", description: "Elige antes un waypoint." }),
    ).toBeDefined();
    await user.click(cell("altitude_ft", 0));
    await user.click(button("Bajar"));
    await user.click(button("Insertar"));
    expect(altitudes()).toEqual(["1000", "700", "850", "1000"]);
    await user.click(button("Quitar"));
    await user.click(button("Subir"));
    expect(altitudes()).toEqual(["1000", "1000", "700"]);
  });
});

describe("an upload", () => {
  test("sends all of it, and says that the board has it only when that was read back", async () => {
    await downloaded();
    await write("altitude_ft", 0, "850{Enter}");
    await sendFlown();
    const asked = newest("PUT", /missions\/flight$/);
    const sent = plan.with(0, { ...plan[0], altitude_ft: 850 } as Waypoint);
    expect(asked.body).toEqual({ waypoints: sent });
    expect(state()).toBe("distinto del de la placa");
    await asked.answer({ plan: "flight", waypoints: sent });
    expect(state()).toBe("igual que en la placa");
  });

  test("that the board refused leaves the plan marked as other than the board's", async () => {
    await downloaded();
    await write("altitude_ft", 0, "850{Enter}");
    await sendFlown();
    const problem = { code: "mission_refused", detail: "No.", params: { reason: "bad_value" } };
    await newest("PUT", /flight$/).answer(problem, 502);
    expect(state()).toBe("distinto del de la placa");
    expect(screen.getByRole("alert").textContent).toContain("sigue el anterior");
  });

  test("is prevented by an error, which is told beside the plan and in its cell", async () => {
    await downloaded();
    await write("latitude_deg", 1, "127.9{Enter}");
    expect(cell("latitude_deg", 1).getAttribute("aria-invalid")).toBe("true");
    expect(document.body.textContent).toContain("Waypoint 2, Latitud: 127.9 está fuera de -90 … 90.");
    await user.click(screen.getByRole("button", { name: "Enviar a la placa", description: /Corrige antes/ }));
    expect(station.asked).toHaveLength(1);
  });

  test("is not prevented by a warning", async () => {
    await downloaded();
    await write("altitude_ft", 1, "1600{Enter}");
    expect(document.body.textContent).toContain("Waypoint 2: el tramo tiene 9.4°");
    await sendFlown();
    expect(newest("PUT", /flight$/).body).toMatchObject({ waypoints: [{}, { altitude_ft: 1600 }, {}] });
  });

  test("by another station makes unknown what the board has", async () => {
    await downloaded();
    const data = { plan: "flight", state: "pending", count: 3, client: "c9" };
    station.deliver({ type: "event", event: "mission", t_s: 1, data });
    expect(state()).toBe("plan de la placa aún sin leer");
  });

  test("is unknown after the board was lost", async () => {
    await downloaded();
    station.status(aStatus({ board: { ...aStatus().board, state: "lost" } }));
    expect(state()).toBe("plan de la placa aún sin leer");
  });
});

describe("in flight", () => {
  const fms_plan = { bearing_deg: 90, altitude_ft: 1000, speed_kt: 55, distance_m: 900, waypoint: 1 };

  test("the waypoint that is flown to is marked while that is live and the plan is the board's", async () => {
    await downloaded();
    const marked = () =>
      [...document.querySelectorAll('tr[data-active="true"]')].map((row) => row.textContent);
    expect(marked()).toEqual([]);
    station.send({ fms_plan });
    expect(marked()).toHaveLength(1);
    expect(marked()[0]).toContain("en vuelo");
    await write("altitude_ft", 0, "850{Enter}");
    expect(marked()).toEqual([]);
    expect(document.body.textContent).toContain("La placa vuela al waypoint 2.");
    station.pass(5000);
    expect(document.body.textContent).toContain("No se sabe a qué waypoint vuela la placa.");
  });

  test("next, previous and go to are commands with their own proof", async () => {
    await downloaded();
    await user.click(button("Next"));
    expect(newest("POST", /commands/).path).toBe("/api/v1/commands/fms_next_waypoint");
    await user.click(button("Previous"));
    expect(newest("POST", /commands/).path).toBe("/api/v1/commands/fms_previous_waypoint");
    await user.click(cell("altitude_ft", 2));
    await user.click(button("Ir a 3"));
    expect(newest("POST", /commands/)).toMatchObject({
      path: "/api/v1/commands/go_to_waypoint",
      body: { value: { plan: 0, index: 2 } },
    });
  });

  test("one cannot go to a waypoint of a plan that the board does not have", async () => {
    await downloaded();
    await user.click(cell("altitude_ft", 2));
    await write("altitude_ft", 0, "850{Enter}");
    expect(screen.getByRole("button", { name: /Ir a/, description: /no tiene este plan/ })).toBeDefined();
  });
});

test("a board that has not spoken yet is not called too old: the buttons say that it is not known", async () => {
  const { board } = legacy;
  open({ ...legacy, board: { ...board, mode: null } });
  await user.click(screen.getByRole("tab", { name: "Plan HIL" }));
  expect(document.body.textContent).not.toContain("firmware más nuevo");
  await user.click(screen.getByRole("button", { name: "Descargar de la placa", description: /no ha dicho/ }));
  expect(station.asked).toEqual([]);
});

describe("on a board that does not transfer plans", () => {
  test("what cannot be done says so, and the rest works", async () => {
    open(legacy);
    await user.click(screen.getByRole("tab", { name: "Plan HIL" }));
    expect(document.body.textContent).toContain("Esta placa no transfiere planes");
    await user.click(
      screen.getByRole("button", { name: "Descargar de la placa", description: /no lo admite/ }),
    );
    await user.click(screen.getByRole("button", { name: "Enviar a la placa", description: /no lo admite/ }));
    expect(station.asked).toEqual([]);
    await user.selectOptions(screen.getByRole("combobox", { name: "Ruta HIL" }), "gando");
    await user.click(button("Copiar a la tabla"));
    expect(altitudes()).toHaveLength(8);
    await user.click(button("Cargar en la placa"));
    await newest("POST", /hil_load_gando$/).answer({ state: "confirmed", by: "plan", ms: 90, reason: null });
    await user.click(button("Next"));
    expect(station.asked.map(({ path }) => path)).toEqual([
      "/api/v1/commands/hil_load_gando",
      "/api/v1/commands/hil_fms_next_waypoint",
    ]);
  });
});

test("a built-in route is loaded in flight only after a question", async () => {
  open();
  station.send({ heartbeat: { autopilot_hil: true } });
  await user.click(screen.getByRole("tab", { name: "Plan HIL" }));
  await user.selectOptions(screen.getByRole("combobox", { name: "Ruta HIL" }), "vuelo");
  await user.click(button("Cargar en la placa"));
  const question = () => screen.getByRole("alertdialog", { name: "¿Cargar una ruta en vuelo?" });
  await user.click(within(question()).getByRole("button", { name: "Cancelar" }));
  expect(station.asked).toEqual([]);
  await user.click(button("Cargar en la placa"));
  await user.click(within(question()).getByRole("button", { name: "Cargar y volarla" }));
  expect(station.asked.map(({ path }) => path)).toEqual(["/api/v1/commands/hil_load_vuelo"]);
});

test("a built-in route is taken by the board, and then read from it", async () => {
  open();
  await user.click(screen.getByRole("tab", { name: "Plan HIL" }));
  await user.selectOptions(screen.getByRole("combobox", { name: "Ruta HIL" }), "vuelo");
  await user.click(button("Cargar en la placa"));
  await newest("POST", /hil_load_vuelo$/).answer({ state: "confirmed", by: "plan", ms: 90, reason: null });
  await newest("GET", /missions\/hil$/).answer({ plan: "hil", waypoints: plan });
  expect(altitudes()).toEqual(["700", "1000", "1000"]);
  expect(state()).toBe("igual que en la placa");
});

test("the plan that is flown is open first, and stays when the simulator stops", async () => {
  function Later() {
    const [isOpen, setOpen] = useState(false);
    return isOpen ? (
      <PlansView map={() => null} />
    ) : (
      <button type="button" onClick={() => setOpen(true)}>
        Abrir
      </button>
    );
  }
  station = new Station(
    <WordsProvider words={WORDS}>
      <Later />
    </WordsProvider>,
  );
  station.greet();
  station.send({ simulator: { latitude_deg: 28 } });
  await user.click(button("Abrir"));
  const isOpen = (): string | null =>
    screen.getByRole("tab", { name: "Plan HIL" }).getAttribute("aria-selected");
  expect(isOpen()).toBe("true");
  station.pass(60_000);
  expect(isOpen()).toBe("true");
});
