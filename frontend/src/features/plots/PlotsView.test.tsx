import { act, fireEvent, screen, within } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { afterEach, beforeEach, describe, expect, test, vi } from "vitest";
import { aStatus } from "../../test/aStatus";
import { type FakeRequest, Station } from "../../test/station";
import { WORDS } from "../../ui/test/testWords";
import { WordsProvider } from "../../ui/words";
import { Chart } from "./chart";
import { valueAt } from "./drawn";
import { PlotsView } from "./PlotsView";
import { PLOTS } from "./plots";

const user = userEvent.setup();
const STARTS_S = 1_700_000_000 - 100;
const TOPICS = [
  { name: "ahrs", fields: ["roll_deg", "pitch_deg"], unit: "deg" },
  { name: "inertial", fields: ["gx_rad_s"], unit: "rad/s" },
  { name: "fms_hil_plan", fields: ["bearing_deg"], unit: "deg" },
].map(({ name, fields, unit }) => ({
  name,
  count: 100,
  first_s: 0,
  last_s: 100,
  fields: fields.map((field) => ({ name: field, unit, kind: "number" })),
}));

let station: Station;
let done: Set<FakeRequest>;

beforeEach(() => {
  done = new Set();
});

afterEach(() => {
  vi.restoreAllMocks();
});

/** The tab with a flight that is being recorded. */
function open(active = true): void {
  station = new Station(
    <WordsProvider words={WORDS}>
      <PlotsView />
    </WordsProvider>,
  );
  const status = aStatus();
  station.greet({ ...status, recording: { ...status.recording, active } });
}

/** What the page asked of the flights and has no answer to yet. */
function waiting(): readonly FakeRequest[] {
  return station.asked.filter((asked) => asked.path.startsWith("/api/v1/flights") && !done.has(asked));
}

function isSignals({ path }: FakeRequest): boolean {
  return path.includes("/signals?");
}

function queryOf({ path }: FakeRequest): URLSearchParams {
  return new URLSearchParams(path.split("?")[1]);
}

interface Steps {
  readonly at_s: readonly number[];
  readonly min: ReadonlyArray<number | null>;
  readonly max: ReadonlyArray<number | null>;
}

const STEADY: Steps = { at_s: [0, 25, 50, 75, 100], min: [1, 2, 3, 4, 5], max: [1, 2, 9, 4, 5] };

/** Answers everything; every signal has these steps. */
async function answer(steps: Steps = STEADY): Promise<void> {
  for (let open = waiting(); open.length > 0; open = waiting()) {
    for (const asked of open) {
      done.add(asked);
      await asked.answer(isSignals(asked) ? signals(asked, steps) : answerTo(asked.path));
    }
    // An answer leads to the next question only some promises later.
    await act(() => new Promise((resolve) => setTimeout(resolve, 0)));
  }
  station.pass(120);
}

function answerTo(path: string): unknown {
  if (path.includes("/topics")) {
    return { topics: TOPICS };
  }
  if (path.startsWith("/api/v1/flights?")) {
    return {
      flights: [],
      total: 0,
      tags: [],
      boards: [],
      all_aircraft: [],
      operators: [],
      unnamed: [],
      indexing: [],
      disk: {
        free_bytes: 1,
        used_bytes: 1,
        hours_left: null,
        policy: { delete_oldest: false, keep_free_bytes: 1 },
      },
    };
  }
  return {};
}

function signals(asked: FakeRequest, steps: Steps): unknown {
  const names = (queryOf(asked).get("names") ?? "").match(/\w+\([^)]*\)|[\w.]+/g) ?? [];
  return {
    starts_s: STARTS_S,
    from_s: 0,
    to_s: 100,
    signals: names.map((name) => ({
      name,
      unit: name.includes("rad_s") ? "rad/s" : "deg",
      ...steps,
      mean: 3.5,
      count: steps.at_s.length,
    })),
  };
}

function pane(number: number): HTMLElement {
  return screen.getByRole("region", { name: `Gráfica ${number}` });
}

function figures(number: number, name: RegExp): string[] {
  const row = within(pane(number)).getByRole("rowheader", { name }).closest("tr");
  return [...(row?.querySelectorAll("td") ?? [])].map((cell) => cell.textContent ?? "");
}

function newestSignals(): URLSearchParams {
  const asked = station.asked.filter(isSignals).at(-1);
  if (asked === undefined) {
    throw new Error("no signals were asked for");
  }
  return queryOf(asked);
}

describe("the figures beside a plot", () => {
  test("are the extremes and the mean of the stretch, the value now, and rates in degrees", async () => {
    open();
    await answer();
    expect(figures(1, /ahrs\.roll_deg/).slice(1, 5)).toEqual(["1.0000", "3.5000", "9.0000", "°"]);
    expect(figures(2, /inertial\.gx_deg_s/).slice(1, 5)).toEqual(["57.296", "200.54", "515.66", "°/s"]);
  });

  test("say of a signal that the flight has not that it is missing, and do not ask for it", async () => {
    open();
    await answer();
    expect(figures(1, /simulator\.roll_deg/)).toEqual(["no está en este vuelo", ""]);
    expect(newestSignals().get("names")).toBe("ahrs.roll_deg,inertial.gx_rad_s");
  });

  test("have no value in a gap", async () => {
    open();
    await answer({ at_s: [0, 25, 50, 75, 100], min: [1, 2, null, 4, 5], max: [1, 2, null, 4, 5] });
    const plots = station.page.parts.get(PLOTS);
    const { signals: known } = plots.feed.store.getState();
    const drawn = known.get("ahrs.roll_deg");
    expect(drawn && [valueAt(drawn, 48), valueAt(drawn, 70)]).toEqual([null, [4, 4]]);
  });

  test("follow the newest sample while the flight is under way", async () => {
    open();
    await answer();
    station.pass(100);
    station.send({ ahrs: { roll_deg: 42, pitch_deg: 0, yaw_deg: 0 } });
    expect(figures(1, /ahrs\.roll_deg/)[0]).toBe("42.000");
    station.pass(3000);
    expect(figures(1, /ahrs\.roll_deg/)[0]).toBe("–");
  });
});

test("a live plot is drawn anew when it has moved by two pixels, and its value with every text", async () => {
  vi.spyOn(Chart.prototype, "pixel_s").mockReturnValue(0.2);
  const draw = vi.spyOn(Chart.prototype, "draw");
  open();
  await answer();
  station.pass(500);
  draw.mockClear();
  const values = new Set<string | undefined>();
  for (let step = 0; step < 20; step += 1) {
    station.send({ ahrs: { roll_deg: step, pitch_deg: 0, yaw_deg: 0 } });
    station.pass(100);
    values.add(figures(1, /ahrs\.roll_deg/)[0]);
  }
  // Each step shows 0.3 s: 6 s are fifteen times 0.4 s.
  const drawn = draw.mock.contexts.filter((chart) => chart === draw.mock.contexts[0]).length;
  expect(drawn).toBeGreaterThanOrEqual(13);
  expect(drawn).toBeLessThanOrEqual(16);
  expect(values.size).toBeGreaterThan(12);
  draw.mockClear();
  station.pass(500);
  expect(draw, "the last sample is not left out").toHaveBeenCalled();
});

describe("what is asked for", () => {
  test("is the last minute of the flight under way, and again as it grows", async () => {
    open();
    await answer();
    const before = station.asked.filter(isSignals).length;
    station.send({ ahrs: { roll_deg: 1, pitch_deg: 0, yaw_deg: 0 } });
    station.pass(2500);
    await answer();
    expect(station.asked.filter(isSignals)).toHaveLength(before + 1);
    expect(Number(newestSignals().get("from_s"))).toBeGreaterThan(42);
  });

  test("is the stretch that was zoomed to, with one question under way at a time", async () => {
    open();
    await answer();
    await user.click(screen.getByRole("button", { name: "Todo el vuelo" }));
    await answer();
    await user.click(screen.getByRole("button", { name: "Acercar" }));
    await user.click(screen.getByRole("button", { name: "Acercar" }));
    expect(waiting().filter(isSignals)).toHaveLength(1);
    await answer();
    expect(Number(newestSignals().get("to_s")) - Number(newestSignals().get("from_s"))).toBeCloseTo(25, 0);
  });

  test("is nothing without a flight, and the page says so", () => {
    open(false);
    expect(screen.getByText(/no se graba ningún vuelo/).closest("[role=status]")).not.toBeNull();
    expect(station.asked.filter(isSignals)).toEqual([]);
  });
});

test("a question that fails says why, and can be asked again", async () => {
  open();
  const topics = waiting().find(({ path }) => path.includes("/topics"));
  await topics?.answer({ code: "flight_not_indexed", detail: "wait", params: { flight: "x" } }, 409);
  done = new Set(topics === undefined ? [] : [topics]);
  expect(screen.getByRole("alert").textContent).toContain("No se han podido cargar las señales");
  await user.click(screen.getByRole("button", { name: "Reintentar" }));
  await answer();
  expect(screen.queryByRole("alert")).toBeNull();
  expect(figures(1, /ahrs\.roll_deg/)[1]).toBe("1.0000");
});

describe("the panes", () => {
  test("take signals from the tree, also computed ones, and are remembered", async () => {
    open();
    await answer();
    await user.click(screen.getByRole("button", { name: "Añadir una gráfica" }));
    await user.type(screen.getByRole("textbox", { name: "Buscar una señal" }), "pitch");
    await user.click(screen.getByRole("button", { name: "Añadir ahrs.pitch_deg" }));
    await user.selectOptions(screen.getByRole("combobox", { name: "Cálculo" }), "diff");
    await user.selectOptions(screen.getByRole("combobox", { name: "Señal A" }), "ahrs.roll_deg");
    await user.selectOptions(screen.getByRole("combobox", { name: "Señal B" }), "ahrs.pitch_deg");
    await user.click(screen.getByRole("button", { name: "Añadir la calculada" }));
    await answer();
    expect(figures(4, /^ahrs\.pitch_deg/)[1]).toBe("1.0000");
    expect(figures(4, /ahrs\.roll_deg − ahrs\.pitch_deg/)[1]).toBe("1.0000");
    expect(newestSignals().get("names")).toContain("diff(ahrs.roll_deg,ahrs.pitch_deg)");
    expect(station.page.settings.getState().choices["plots.panes"]).toContain("diff(");
  });

  test("can be moved and removed, and a signal taken out", async () => {
    open();
    await answer();
    await user.click(screen.getByRole("button", { name: "Bajar la gráfica 1" }));
    expect(within(pane(2)).getByRole("rowheader", { name: /ahrs\.roll_deg/ })).toBeDefined();
    await user.click(screen.getByRole("button", { name: "Quitar ahrs.roll_deg" }));
    expect(screen.queryByRole("rowheader", { name: /ahrs\.roll_deg/ })).toBeNull();
    await user.click(screen.getByRole("button", { name: "Quitar la gráfica 3" }));
    expect(screen.queryByRole("region", { name: "Gráfica 3" })).toBeNull();
  });

  test("can be saved under a name, chosen again and deleted", async () => {
    open();
    await answer();
    await user.click(screen.getByRole("button", { name: "Quitar la gráfica 3" }));
    await user.click(screen.getByRole("button", { name: "Guardar" }));
    await user.type(screen.getByRole("textbox", { name: "Nombre" }), "Mi lazo{Enter}");
    const layout = () => screen.getByRole("combobox", { name: "Disposición" });
    await user.selectOptions(layout(), "Batería");
    expect(within(pane(1)).getByRole("rowheader", { name: /battery_v/ })).toBeDefined();
    await user.selectOptions(layout(), "Mi lazo");
    expect(screen.queryByRole("region", { name: "Gráfica 3" })).toBeNull();
    await user.click(screen.getByRole("button", { name: "Borrar la disposición" }));
    expect(within(layout()).queryByRole("option", { name: "Mi lazo" })).toBeNull();
  });
});

test("a click sets the moment after the time of a double click, which shows all instead", async () => {
  open();
  await answer();
  const plots = station.page.parts.get(PLOTS);
  const over = pane(1).querySelector(".u-over") as HTMLElement;
  const click = () => {
    fireEvent.pointerDown(over, { pointerId: 1, button: 0, clientX: 0 });
    fireEvent.pointerUp(over, { pointerId: 1, button: 0, clientX: 0 });
  };
  act(click);
  act(click);
  act(() => void fireEvent.dblClick(over));
  station.pass(400);
  expect(plots.store.getState().view).toEqual({ kind: "all" });
  expect(station.replays).toHaveLength(0);
  act(click);
  station.pass(400);
  expect(station.replays).toHaveLength(1);
});

test("the table of what is seen has the extremes of each step with its time", async () => {
  open();
  await answer();
  await user.click(screen.getByRole("button", { name: "Todo el vuelo" }));
  await answer();
  await user.click(screen.getByRole("button", { name: "Guardar lo que se ve como CSV" }));
  const [file] = station.saved;
  const lines = ((await file?.content.text()) ?? "").split("\r\n");
  expect(file?.name).toBe("20231114T221140Z_0-00.csv");
  expect(lines[0]?.split(",").slice(0, 4)).toEqual([
    "time_utc",
    "at_s",
    "current ahrs.roll_deg [deg] min",
    "current ahrs.roll_deg [deg] max",
  ]);
  expect(lines[0]).toContain("inertial.gx_deg_s [deg/s]");
  expect(lines[0]).not.toContain("rad");
  expect(lines[3]).toMatch(/^2023-11-14T22:12:30\.000Z,50\.000000,3,9,/);
});

test("a second flight is laid over by its own start", async () => {
  open();
  await answer();
  act(() => station.page.parts.get(PLOTS).store.setState({ compared: "20260131T120000Z", shift_s: 10 }));
  await answer();
  const asked = station.asked.filter(isSignals).find(({ path }) => path.includes("20260131T120000Z"));
  expect(asked).toBeDefined();
  expect(figures(1, /20260131T120000Z · ahrs\.roll_deg/)[1]).toBe("1.0000");
  const other = station.page.parts.get(PLOTS).other.store.getState();
  expect(other.signals.get("ahrs.roll_deg")?.at_s).toEqual([-10, 15, 40, 65, 90]);
});
