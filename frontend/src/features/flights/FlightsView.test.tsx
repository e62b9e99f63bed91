import { fireEvent, screen, waitFor, within } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { beforeEach, describe, expect, test } from "vitest";
import { formatDateTime } from "../../lib/moment";
import { aStatus, heldBy } from "../../test/aStatus";
import { aFlight, aFlightEvent, aFlightList } from "../../test/flights";
import { type FakeRequest, Station } from "../../test/station";
import { Tab } from "../../test/tab";

const user = userEvent.setup();
const FIRST = aFlight();
const SECOND = aFlight({ id: "20231113T090000Z", started_s: 1_699_866_000, title: "", alarms: 2, tags: [] });
const BOTH = aFlightList({ flights: [FIRST, SECOND] });
const ID = FIRST.id;

let station: Station;

function asked(method: string, path: RegExp): FakeRequest[] {
  // The bar asks about the flight being recorded; what is asked of another flight is the tab's question.
  const ofOthers = station.askedByBar.filter((question) => !question.path.includes("/flights/current/"));
  return [...station.asked, ...ofOthers].filter(
    (question) => question.method === method && path.test(question.path),
  );
}

function newest(method: string, path: RegExp): FakeRequest {
  const found = asked(method, path).at(-1);
  if (found === undefined) {
    throw new Error(`nothing was asked with ${method} ${path}`);
  }
  return found;
}

const LIST = /\/flights\?.*sort=/;

async function open(list: unknown = BOTH, status = aStatus()): Promise<void> {
  station = new Station(<Tab name="flights" />);
  station.greet(status);
  station.show();
  await newest("GET", LIST).answer(list);
}

function row(name: RegExp): HTMLElement {
  const list = screen.getByRole("list", { name: "Vuelos grabados" });
  return within(list).getByRole("button", { name });
}

/** The lines of what happened; a mark has buttons of its own beside it. */
function happened(): HTMLElement[] {
  const list = screen.getByRole("list", { name: "Qué pasó" });
  return within(list).getAllByRole("button", { name: /^\d+:\d\d/ });
}

async function select(name = /^Primera vuelta/, events: unknown[] = []): Promise<void> {
  await user.click(row(name));
  await newest("GET", /events$/).answer({ events });
}

function detail(): HTMLElement {
  return screen.getByRole("region", { name: /^Vuelo / });
}

function button(name: string | RegExp, within_: HTMLElement = document.body): HTMLElement {
  return within(within_).getByRole("button", { name });
}

describe("at first start", () => {
  test("the tab says what will be here, and how to bring in a recording", async () => {
    await open(aFlightList({ flights: [], tags: [], boards: [] }));
    expect(screen.getByRole("heading", { name: "Aquí estarán tus vuelos" })).toBeTruthy();
    expect(screen.getByText(/importar una grabación de otra máquina/)).toBeTruthy();
  });

  test("a recording that was renamed in its folder is named, with what to do", async () => {
    await open(aFlightList({ unnamed: ["my flight.mcap"] }));
    expect(screen.getByText(/^my flight\.mcap está en la carpeta de grabaciones.*impórtalo/)).toBeTruthy();
  });

  test("a list that cannot be read says why", async () => {
    station = new Station(<Tab name="flights" />);
    station.greet();
    await newest("GET", LIST).answer(
      { code: "flight_not_written", detail: "x", params: { why: "lleno" } },
      409,
    );
    expect(screen.getByRole("tabpanel", { name: "Vuelos" }).textContent).toContain("lleno");
  });
});

describe("the list", () => {
  beforeEach(async () => await open());

  test("tells of each flight its start, numbers, tags and what deserves a look", () => {
    const text = row(/^Primera vuelta/).textContent;
    for (const words of [
      formatDateTime(FIRST.started_s),
      "12:34",
      "9.87 NM",
      "1234 ft",
      "71.2 kt",
      "12.3 MB",
      "isla",
    ]) {
      expect(text).toContain(words);
    }
    // Without a title a flight is called by its start.
    const other = row(new RegExp(`^${formatDateTime(SECOND.started_s)}`));
    expect(other.querySelector('[data-figure="alarms"]')?.getAttribute("data-caution")).toBe("true");
  });

  test("shows a gap of the altitude as a gap, and north of the track above", () => {
    const [track, altitude] = row(/^Primera vuelta/).querySelectorAll("path");
    expect(track?.getAttribute("d")).toBe("M3.0 37.0L37.0 3.0");
    expect(altitude?.getAttribute("d")?.match(/M/g)).toHaveLength(2);
  });

  test("is walked with the arrow keys, and Enter opens a flight at its start on every tab", async () => {
    row(/^Primera vuelta/).focus();
    await user.keyboard("{ArrowDown}");
    expect(document.activeElement?.getAttribute("data-flight")).toBe(SECOND.id);
    await user.keyboard("{ArrowDown}");
    expect(document.activeElement?.getAttribute("data-flight")).toBe(SECOND.id);
    await user.keyboard("{Home}{Enter}");
    expect(station.replay.place).toEqual({ flight: ID, at_s: 0 });
  });

  test("has one stop of the Tab key, where the arrow keys left it", async () => {
    row(/^Primera vuelta/).focus();
    await user.keyboard("{ArrowDown}");
    expect([row(/^Primera/).tabIndex, row(/^2023/).tabIndex]).toEqual([-1, 0]);
  });

  test("is searched a moment after the last key, and by tag, day and order at once", async () => {
    await user.type(screen.getByRole("searchbox", { name: "Buscar" }), "isla");
    expect(asked("GET", /text=/)).toEqual([]);
    station.pass(400);
    expect(newest("GET", LIST).path).toContain("text=isla&");
    await user.selectOptions(screen.getByRole("combobox", { name: "Etiqueta" }), "viento");
    expect(newest("GET", LIST).path).toContain("tag=viento");
    await user.selectOptions(screen.getByRole("combobox", { name: "Aeronave" }), "Libélula");
    await user.selectOptions(screen.getByRole("combobox", { name: "Operador" }), "Ana");
    expect(new URL(newest("GET", LIST).path, "http://station").searchParams.get("aircraft")).toBe("Libélula");
    expect(newest("GET", LIST).path).toContain("operator=Ana");
    fireEvent.change(screen.getByLabelText("Hasta el día"), { target: { value: "2023-11-14" } });
    // The whole day counts.
    expect(newest("GET", LIST).path).toContain(`to_s=${new Date(2023, 10, 15).getTime() / 1000}`);
    await user.selectOptions(screen.getByRole("combobox", { name: "Ordenar por" }), "highest");
    await user.click(button(/^De mayor a menor/));
    expect(newest("GET", LIST).path).toContain("sort=highest&order=asc&page=1");
    await newest("GET", LIST).answer(aFlightList({ flights: [] }));
    expect(screen.getByText("Ningún vuelo cumple lo que se busca.")).toBeTruthy();
    await user.click(button("Quitar filtros"));
    expect(newest("GET", LIST).path).toBe("/api/v1/flights?sort=highest&order=asc&page=1&per_page=50");
  });

  test("is shown as it was asked for last, however late an older answer comes", async () => {
    await user.click(button(/^De mayor a menor/));
    const older = newest("GET", LIST);
    await user.click(button(/^De menor a mayor/));
    await newest("GET", LIST).answer(BOTH);
    await older.answer(aFlightList({ flights: [] }));
    expect(row(/^Primera vuelta/)).toBeTruthy();
  });

  test("is turned page by page", async () => {
    await user.click(button(/^De mayor a menor/));
    await newest("GET", LIST).answer({ ...BOTH, total: 120 });
    expect(button("Página anterior").getAttribute("aria-disabled")).toBe("true");
    await user.click(button("Página siguiente"));
    expect(newest("GET", LIST).path).toContain("page=2");
  });
});

describe("the flight that is being recorded", () => {
  const recording = {
    ...aStatus().recording,
    file: "/data/recordings/20231114T221000Z.mcap",
    bytes: 1_000_000,
  };

  test("stands on top with its growing size, and opens as far as it is", async () => {
    const active = aFlight({ id: "20231114T221000Z", active: true, state: "recording", title: "ahora" });
    await open(aFlightList({ flights: [active, FIRST] }), aStatus({ recording }));
    const running = screen.getByRole("region", { name: "Grabándose ahora" });
    expect(running.textContent).toContain("1.00 MB");
    expect(running.textContent).toContain("3:20");
    station.status(aStatus({ recording: { ...recording, bytes: 2_500_000 } }));
    expect(running.textContent).toContain("2.50 MB");
    expect(
      within(screen.getByRole("list", { name: "Vuelos grabados" })).getAllByRole("listitem"),
    ).toHaveLength(1);
    await user.click(button("Ver desde el principio"));
    expect(station.replay.place).toEqual({ flight: "current", at_s: 0 });
    station.replayed((replay) => replay.greet());
    expect(station.replay.asked.at(-1), "it flies at once").toMatchObject({ type: "play" });
  });

  test("becomes one of the list when it ends", async () => {
    await open(BOTH, aStatus({ recording }));
    const before = asked("GET", LIST).length;
    station.status(aStatus({ recording: { ...recording, active: false, file: null } }));
    expect(screen.queryByRole("region", { name: "Grabándose ahora" })).toBeNull();
    expect(asked("GET", LIST).length).toBe(before + 1);
  });
});

describe("a flight that is chosen", () => {
  const EVENTS = [
    aFlightEvent({
      kind: "command",
      name: "autopilot_on",
      at_s: 5,
      data: { state: "confirmed", by: "heartbeat", ms: 80, reason: null },
    }),
    aFlightEvent({
      kind: "alarm",
      name: "battery_low",
      at_s: 12.5,
      until_s: 1_699_956_014,
      data: { level: "warning", text: "Low", params: { battery_v: 9.8 } },
    }),
    aFlightEvent({ kind: "mark", id: "m1", at_s: 20, data: { text: "viraje raro" } }),
    aFlightEvent({ kind: "gap", name: "silence", at_s: 30 }),
    aFlightEvent({ kind: "link", at_s: 31, data: { board: "open", simulator: "closed" } }),
  ];

  beforeEach(async () => {
    await open();
    await select(/^Primera vuelta/, EVENTS);
  });

  test("tells what happened in it, and a press opens it at that moment", async () => {
    const events = happened();
    expect(events.map(({ textContent }) => textContent)).toEqual([
      "0:05.0Autopilot On: confirmado por el latido en 80 ms.",
      expect.stringContaining("Batería baja: 9.8 V"),
      "0:20.0Marca: viraje raro",
      "0:30.0Sin datos",
      "0:31.0Enlaces: placa conectado, X-Plane cerrado",
    ]);
    await user.click(events[1] as HTMLElement);
    expect(station.replay.place).toEqual({ flight: ID, at_s: 12.5 });
  });

  test("hides the kinds of events that are not wanted", async () => {
    await user.click(button("Órdenes (1)"));
    const events = happened();
    expect(events).toHaveLength(4);
  });

  test("stays chosen when the past is opened, with the focus on it, and can still be edited and deleted", async () => {
    await user.click(button("Abrir", detail()));
    station.replayed((replay) => replay.greet());
    expect(detail().textContent).toContain("Primera vuelta");
    expect(document.activeElement?.getAttribute("data-flight")).toBe(ID);
    expect(button("Borrar…").getAttribute("aria-disabled")).toBeNull();
    const title = within(detail()).getByRole("textbox", { name: "Título" });
    await user.clear(title);
    await user.type(title, "Otra{Enter}");
    expect(newest("PATCH", new RegExp(`${ID}$`)).body).toEqual({ title: "Otra" });
  });

  test("is given a title, tags and notes, and stands as the gateway keeps them", async () => {
    await user.type(within(detail()).getByRole("textbox", { name: "Añadir etiqueta" }), "viento{Enter}");
    const change = newest("PATCH", new RegExp(`${ID}$`));
    expect(change.body).toEqual({ tags: ["isla", "viento"] });
    await change.answer(aFlight({ tags: ["isla", "viento"] }));
    expect(row(/^Primera vuelta/).textContent).toContain("viento");
    await user.click(button("Quitar la etiqueta isla"));
    expect(newest("PATCH", /./).body).toEqual({ tags: ["viento"] });
    await user.type(within(detail()).getByRole("textbox", { name: "Notas" }), "con viento");
    await user.tab();
    expect(newest("PATCH", /./).body).toEqual({ notes: "con viento" });
  });

  test("is pinned, and says why it is not if the disk refuses", async () => {
    const [pin] = screen.getAllByRole("button", { name: /^Fijar Primera vuelta/ });
    await user.click(pin as HTMLElement);
    const change = newest("PATCH", /./);
    expect(change.body).toEqual({ pinned: true });
    await change.answer({ code: "flight_not_written", detail: "x", params: { why: "solo lectura" } }, 409);
    expect(screen.getAllByText(/solo lectura/).length).toBeGreaterThan(0);
  });

  test("is deleted only after the question that names it, and comes back with one press", async () => {
    await user.click(button("Borrar…"));
    const question = screen.getByRole("alertdialog");
    expect(question.textContent).toContain(`Primera vuelta (${formatDateTime(FIRST.started_s)})`);
    await user.click(button("Conservarlo", question));
    expect(asked("DELETE", /./)).toEqual([]);
    await user.click(button("Borrar…"));
    await user.click(button("Borrar el vuelo"));
    const deletion = newest("DELETE", /./);
    expect(deletion.path).toBe(`/api/v1/flights/${ID}?confirm=${ID}`);
    await deletion.answer({ flights: [] });
    await newest("GET", LIST).answer(aFlightList({ flights: [SECOND] }));
    expect(screen.queryByRole("region", { name: /^Vuelo / })).toBeNull();
    await user.click(button("Recuperar Primera vuelta"));
    await newest("POST", /restore$/).answer(FIRST);
    await newest("GET", LIST).answer(BOTH);
    expect(row(/^Primera vuelta/)).toBeTruthy();
    expect(screen.queryByText(/^Borrado:/)).toBeNull();
  });
});

test("a viewer may neither delete nor import nor change the policy, and is told why", async () => {
  await open(BOTH, aStatus({ control: heldBy("c2", "Ana") }));
  await select();
  await user.click(button("Borrar…"));
  expect(screen.queryByRole("alertdialog")).toBeNull();
  await user.click(screen.getByRole("checkbox", { name: /^Si falta sitio/ }));
  expect(station.asked.filter(({ method }) => method !== "GET")).toEqual([]);
  expect(button("Importar…").getAttribute("aria-disabled")).toBe("true");
  expect(detail().textContent).toContain("Espectador: el control lo tiene Ana.");
});

test("a flight whose recording lies there twice names the other file", async () => {
  await open(aFlightList({ flights: [aFlight({ copies: ["20260101T000000Z-2"] })] }));
  await select();
  expect(detail().textContent).toMatch(/otra vez en la carpeta, como 20260101T000000Z-2\.mcap/);
});

test("a damaged flight says so with the sentence, and one that cannot be read is not opened", async () => {
  const fault = { code: "recording_unreadable", detail: "x", params: { reason: "sin cabecera" } };
  const broken = aFlight({ state: "damaged", fault, thumbnail: null, duration_s: null });
  await open(
    aFlightList({ flights: [broken, aFlight({ ...SECOND, damage: "the file ends inside a chunk" })] }),
  );
  await select();
  expect(detail().textContent).toContain("La grabación no se puede leer: sin cabecera");
  await user.click(button("Abrir", detail()));
  expect(station.replays).toEqual([]);
  expect(row(/^2023/).textContent).toContain("archivo cortado");
});

test("the bin tells the days left", async () => {
  await open();
  await user.click(button("Papelera"));
  const [DAY_S, now_s] = [86_400, aStatus().server_time_s];
  const gone = {
    id: ID,
    title: "Vieja",
    started_s: 1_699_000_000,
    bytes: 5_000_000,
    deleted_s: now_s - 2 * DAY_S,
  };
  await newest("GET", /bin$/).answer({ flights: [{ ...gone, gone_s: now_s + 28 * DAY_S }] });
  const bin = screen.getByRole("dialog", { name: "Papelera" });
  expect(bin.textContent).toContain("quedan 28 días");
  await user.click(button("Recuperar Vieja", bin));
  await newest("POST", /restore$/).answer(FIRST);
  await waitFor(() => expect(bin.textContent).toContain("La papelera está vacía."));
});

test("the disk tells the hours left and what its policy does, and keeps what is chosen", async () => {
  await open();
  const disk = screen.getByRole("region", { name: "Disco" });
  expect(disk.textContent).toContain(
    "50.0 GB libres. Vuelos, papelera, lo preparado para verlos y exportaciones ocupan 3.40 GB. Al terminar, una grabación se comprime y ocupa mucho menos que mientras se graba (REC). Al ritmo de los últimos vuelos quedan 41 h",
  );
  expect(disk.textContent).toContain("No se borra nada solo");
  await user.click(within(disk).getByRole("checkbox"));
  const choice = newest("PUT", /policy$/);
  expect(choice.body).toEqual({ delete_oldest: true, keep_free_bytes: 5_000_000_000 });
  await choice.answer({ ...BOTH.disk, policy: choice.body });
  expect(disk.textContent).toContain("se borran para siempre los vuelos más antiguos");
});

test("the aircraft has the name that a person gives it, and why the station refuses one is said", async () => {
  await open();
  const panel = screen.getByRole("region", { name: "Aeronave" });
  const field = within(panel).getByRole("textbox", { name: "Nombre de la aeronave" });
  await user.type(field, " Ala fija 2 {Enter}");
  const wish = newest("PUT", /aircraft$/);
  expect(wish.body).toEqual({ name: "Ala fija 2" });
  await wish.answer({ name: "Ala fija 2" });
  expect((field as HTMLInputElement).value).toBe("Ala fija 2");
  await user.clear(field);
  await user.type(field, "Otra{Enter}");
  await newest("PUT", /aircraft$/).answer({ code: "flight_away", detail: "x", params: {} }, 409);
  expect((field as HTMLInputElement).value).toBe("Ala fija 2");
  expect(within(panel).getByRole("alert").textContent).not.toBe("");
});
