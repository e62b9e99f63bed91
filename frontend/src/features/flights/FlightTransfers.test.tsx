import { fireEvent, screen, within } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { act } from "react";
import { beforeEach, describe, expect, test } from "vitest";
import { MISSIONS } from "../../missions/planDrafts";
import type { Job } from "../../protocol/guards.gen";
import { aFlight, aFlightList, aJob } from "../../test/flights";
import { type FakeRequest, Station } from "../../test/station";
import { Tab } from "../../test/tab";
import { FLIGHT_COMPARISON } from "./flightComparison";

const user = userEvent.setup();
const FIRST = aFlight();
const SECOND = aFlight({ id: "20231113T090000Z", started_s: 1_699_866_000, title: "Segunda" });
const FILE = new File(["x".repeat(1000)], "ajena.mcap");
const LIST = /\/flights\?.*sort=/;

let station: Station;

function newest(method: string, path: RegExp): FakeRequest {
  const found = station.asked
    .filter((question) => question.method === method && path.test(question.path))
    .at(-1);
  if (found === undefined) {
    throw new Error(`nothing was asked with ${method} ${path}`);
  }
  return found;
}

function tell(parts: Partial<Job>): void {
  station.deliver({ type: "event", event: "job", t_s: 1, data: aJob(parts) });
}

function transfers(): HTMLElement {
  return screen.getByRole("region", { name: "Archivos que entran y salen" });
}

function input(): HTMLInputElement {
  return document.querySelector('input[type="file"]') as HTMLInputElement;
}

beforeEach(async () => {
  station = new Station(<Tab name="flights" />);
  station.greet();
  station.show();
  await newest("GET", LIST).answer(aFlightList({ flights: [FIRST, SECOND] }));
});

describe("a recording from another machine", () => {
  test("is sent with its progress, then checked with its own, and is chosen in the list", async () => {
    await user.upload(input(), FILE);
    expect(station.uploads[0]?.path).toBe("/api/v1/flights?name=ajena.mcap");
    station.uploads[0]?.onSent(400);
    expect(within(transfers()).getByRole("progressbar").getAttribute("value")).toBe("400");
    expect(transfers().textContent).toContain("Enviando ajena.mcap: 400 B de 1.00 kB");
    await newest("POST", /name=/).answer({ job: "0123456789ab" }, 202);
    tell({ kind: "import", flight: null, progress: 0.5 });
    expect(transfers().textContent).toContain("Comprobando ajena.mcap");
    expect(within(transfers()).getByRole("progressbar").getAttribute("value")).toBe("0.5");
    tell({ kind: "import", state: "done", progress: 1, flight: SECOND.id });
    expect(transfers().textContent).toContain("ajena.mcap ya está en la biblioteca.");
    expect(screen.getByRole("region", { name: "Vuelo Segunda" })).toBeTruthy();
    const stories = () => station.asked.filter(({ path }) => path.endsWith(`${SECOND.id}/events`)).length;
    expect(stories(), "it is not prepared yet").toBe(0);
  });

  test("comes in by being dropped, and the refusal is said clearly until it is dismissed", async () => {
    const tab = screen.getByRole("tabpanel", { name: "Vuelos" }).firstElementChild as HTMLElement;
    const dataTransfer = { types: ["Files"], files: [FILE] };
    fireEvent.dragOver(tab, { dataTransfer });
    expect(tab.textContent).toContain("Suelta aquí una grabación o un registro");
    fireEvent.drop(tab, { dataTransfer });
    await newest("POST", /name=/).answer({ job: "0123456789ab" }, 202);
    tell({
      kind: "import",
      flight: null,
      state: "failed",
      fault: { code: "recording_empty", detail: "x", params: {} },
    });
    const refusal = within(transfers()).getByRole("alert");
    expect(refusal.textContent).toContain("No se ha importado ajena.mcap.");
    expect(refusal.textContent).toContain("no contiene ningún mensaje");
    await user.click(within(refusal).getByRole("button"));
    expect(screen.queryByRole("region", { name: "Archivos que entran y salen" })).toBeNull();
  });

  test("that is refused at once says why", async () => {
    await user.upload(input(), FILE);
    await newest("POST", /name=/).answer({ code: "jobs_busy", detail: "x", params: { limit: 20 } }, 409);
    expect(within(transfers()).getByRole("alert").textContent).toContain("Ya hay 20 trabajos en espera");
  });

  test("larger than the gateway takes is refused at once and not sent", async () => {
    const huge = new File(["x"], "enorme.mcap");
    Object.defineProperty(huge, "size", { value: 60_000_000_000 });
    await user.upload(input(), huge);
    expect(within(transfers()).getByRole("alert").textContent).toContain(
      "No se ha importado enorme.mcap.Ocupa 60.0 GB, y ahora caben como mucho 8.00 GB",
    );
    expect(station.uploads).toEqual([]);
    await user.click(within(transfers()).getByRole("button"));
    expect(screen.queryByRole("region", { name: "Archivos que entran y salen" })).toBeNull();
  });

  test("can be stopped while it is sent, and nothing is said of it then", async () => {
    await user.upload(input(), FILE);
    await user.click(screen.getByRole("button", { name: "Cancelar ajena.mcap" }));
    expect(screen.queryByRole("region", { name: "Archivos que entran y salen" })).toBeNull();
  });
});

describe("an export", () => {
  beforeEach(async () => {
    await user.click(screen.getByRole("button", { name: /^Primera vuelta/ }));
    await user.click(screen.getByRole("button", { name: "Exportar…" }));
  });

  test("of a stretch starts as it was chosen, shows its progress, and is there to be fetched", async () => {
    await user.click(screen.getByRole("radio", { name: /^CSV/ }));
    await user.click(screen.getByRole("checkbox", { name: "Solo un tramo del vuelo" }));
    const from = screen.getByRole("textbox", { name: "Desde el segundo" });
    await user.clear(from);
    await user.type(from, "100{Enter}");
    await user.click(screen.getByRole("button", { name: "Exportar" }));
    const wish = newest("POST", /exports$/);
    expect(wish.path).toBe(`/api/v1/flights/${FIRST.id}/exports`);
    expect(wish.body).toEqual({
      format: "csv",
      lang: "es",
      every_point: false,
      topics: null,
      from_s: 100,
      to_s: 754,
    });
    await wish.answer({ job: "0123456789ab" }, 202);
    tell({ progress: 0.75 });
    expect(within(transfers()).getByRole("progressbar").getAttribute("value")).toBe("0.75");
    expect(transfers().textContent, "two of one flight are told apart").toContain(
      "Exportando 20231114T100000Z.csv.zip",
    );
    tell({ state: "done", progress: 1, result: { name: "vuelo.zip", bytes: 4_200_000 } });
    station.pass(6000);
    expect(station.page.messages.getState().last?.key).toBe("flights.saidExported");
    // The answer to the first question of how far it is comes late.
    await newest("GET", /jobs\/0123456789ab$/).answer(aJob({ progress: 0.1 }));
    const link = within(transfers()).getByRole("link", { name: "Descargar vuelo.zip (4.20 MB)" });
    expect(link.getAttribute("href")).toBe("/api/v1/jobs/0123456789ab/result");
    expect(link.getAttribute("download")).toBe("vuelo.zip");
  });

  test("that has ended stays ended where an older answer says that it runs, and its file may go", async () => {
    await user.click(screen.getByRole("button", { name: "Exportar" }));
    const jobs = newest("GET", /\/jobs$/);
    tell({ state: "done", progress: 1, result: { name: "vuelo.mcap", bytes: 4_200_000 } });
    await jobs.answer({ jobs: [aJob({ progress: 0.5 })] });
    expect(within(transfers()).getByRole("link", { name: /^Descargar vuelo.mcap/ })).toBeTruthy();
    tell({ state: "done", progress: 1, result: null });
    expect(screen.queryByRole("region", { name: "Archivos que entran y salen" })).toBeNull();
  });

  test("of a track has few points, unless every one is asked for", async () => {
    expect(
      screen.queryByRole("checkbox", { name: "Todos los puntos" }),
      "of a recording nothing is left out",
    ).toBeNull();
    await user.click(screen.getByRole("radio", { name: /^GPX/ }));
    expect(screen.getByRole("dialog").textContent).toContain("menos de 1 m");
    await user.click(screen.getByRole("checkbox", { name: "Todos los puntos" }));
    await user.click(screen.getByRole("button", { name: "Exportar" }));
    expect(newest("POST", /exports$/).body).toMatchObject({ format: "gpx", every_point: true });
  });

  test("of the whole flight says so, and is cancelled", async () => {
    await user.click(screen.getByRole("button", { name: "Exportar" }));
    expect(newest("POST", /exports$/).body).toMatchObject({ format: "mcap", from_s: null, to_s: null });
    tell({});
    await user.click(screen.getByRole("button", { name: "Cancelar 20231114T100000Z.csv.zip" }));
    await newest("DELETE", /jobs\/0123456789ab$/).answer(aJob({ state: "cancelled" }));
    expect(screen.queryByRole("region", { name: "Archivos que entran y salen" })).toBeNull();
  });
});

test("a flight becomes the plan of its aircraft once its figures were answered, and nothing goes to the board", async () => {
  await user.click(screen.getByRole("button", { name: /^Primera vuelta/ }));
  await user.click(screen.getByRole("button", { name: "Como plan…" }));
  await user.click(screen.getByRole("radio", { name: "Aeronave real" }));
  await user.click(screen.getByRole("button", { name: "Ver en qué queda" }));
  const path = `/api/v1/flights/${FIRST.id}/plan?source=flight`;
  const params = { name: FIRST.id, points: 3600, waypoints: 40, deviation_m: 11.2 };
  const asked = newest("GET", /plan\?/);
  expect(asked.path).toBe(path);
  await asked.answer({ code: "mission_file_track", detail: "No.", params }, 422);
  const plan = () => station.page.parts.get(MISSIONS).plans.getState().flight.draft.present;
  expect(plan()).toEqual([]);
  expect(screen.getByRole("alertdialog").textContent).toContain("Primera vuelta");
  expect(screen.getByRole("alertdialog").textContent).toContain("hasta 12 m");
  await user.click(screen.getByRole("button", { name: "Tomar 40 waypoints" }));
  const again = newest("GET", /plan\?/);
  expect(again.path).toBe(`${path}&thin=true`);
  const waypoint = { latitude_deg: 27.95, longitude_deg: -15.37, altitude_ft: 700, speed_kt: 55 };
  await again.answer({
    format: "flight",
    waypoints: [{ ...waypoint, origin: null }],
    notes: [],
    heights: [],
  });
  expect(plan()).toEqual([waypoint]);
  expect(station.asked.filter(({ method }) => method === "PUT")).toEqual([]);
});

test("a viewer cancels its own export, and another's is an operator's", async () => {
  act(() => station.page.admission.setState({ role: "viewer" }));
  await user.click(screen.getByRole("button", { name: /^Primera vuelta/ }));
  await user.click(screen.getByRole("button", { name: "Exportar…" }));
  await user.click(screen.getByRole("button", { name: "Exportar" }));
  await newest("POST", /exports$/).answer({ job: "0123456789ab" }, 202);
  tell({});
  tell({ id: "ba9876543210", file: "otro.kml" });
  await user.click(screen.getByRole("button", { name: "Cancelar otro.kml" }));
  expect(station.asked.filter(({ method }) => method === "DELETE")).toEqual([]);
  await user.click(screen.getByRole("button", { name: "Cancelar 20231114T100000Z.csv.zip" }));
  expect(newest("DELETE", /jobs\/0123456789ab$/)).toBeTruthy();
});

test("a flight that is being prepared shows how far that is, and is read again when it is ready", async () => {
  tell({ kind: "index", flight: FIRST.id, progress: 0.4 });
  const [bar] = within(screen.getByRole("list", { name: "Vuelos grabados" })).getAllByRole("progressbar");
  expect(bar?.getAttribute("value")).toBe("0.4");
  const before = station.asked.filter(({ path }) => LIST.test(path)).length;
  tell({ kind: "index", flight: FIRST.id, state: "done" });
  expect(screen.queryByRole("progressbar")).toBeNull();
  expect(station.asked.filter(({ path }) => LIST.test(path)).length).toBe(before + 1);
});

test("two flights can be compared by every view that has registered itself, and it gets both", async () => {
  expect(screen.getByRole("button", { name: "Informe" })).toBeTruthy();
  expect(screen.getByRole("button", { name: "Gráficas de ambos" })).toBeTruthy();
  const opened: string[][] = [];
  act(() =>
    station.page.parts
      .get(FLIGHT_COMPARISON)
      .register({ words: "flights.compare", open: (...both) => opened.push(both) }),
  );
  const compare = screen.getByRole("button", { name: "Comparar" });
  await user.click(screen.getByRole("checkbox", { name: "Comparar Segunda" }));
  await user.click(compare);
  expect(opened).toEqual([]);
  await user.click(screen.getByRole("checkbox", { name: "Comparar Primera vuelta" }));
  await user.click(compare);
  expect(opened).toEqual([[SECOND.id, FIRST.id]]);
});
