import { cleanup, screen } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { expect, test, vi } from "vitest";
import { type FakeRequest, Station } from "../../test/station";

const user = userEvent.setup();
const STRANGER = { state: "stranger", kind: null, role: null, name: null, anyone_may_fly: false };
const WAITING = { ...STRANGER, state: "waiting", name: "Ana" };
const ANA = { state: "in", kind: "person", role: "operator", name: "Ana · tableta", anyone_may_fly: false };

function newest(station: Station, path: string): FakeRequest {
  const asked = station.askedAccess.filter((question) => question.path === `/api/v1/access/${path}`).at(-1);
  if (asked === undefined) {
    throw new Error(`the page asked nothing of ${path}`);
  }
  return asked;
}

async function stranger(url?: string): Promise<Station> {
  const station = new Station(undefined, url);
  await newest(station, "me").answer(STRANGER);
  return station;
}

async function sayWho(): Promise<void> {
  await user.type(screen.getByRole("textbox", { name: "Tu nombre" }), "Ana");
  const place = screen.getByRole("textbox", { name: "Desde dónde" });
  await user.clear(place);
  await user.type(place, "tableta");
}

test("on the station's own computer the stream is dialled at once, and nobody is asked anything", async () => {
  const station = new Station();
  expect(station.wires.length).toBe(1);
  station.greet();
  await newest(station, "me").answer({ ...ANA, kind: "local", role: "owner", name: "local" });
  expect(screen.queryByRole("heading", { name: "Entrar en la estación" })).toBeNull();
  expect(screen.getByText("Tienes el control")).toBeTruthy();
});

test("a stranger sees the way in and nothing of the vehicle, and the stream is not dialled again", async () => {
  const station = await stranger();
  expect(screen.getByRole("heading", { name: "Entrar en la estación" })).toBeTruthy();
  expect(screen.queryByRole("tab", { name: "Datos de vuelo" })).toBeNull();
  station.pass(20_000);
  expect(station.wires.length).toBe(1);
  expect(station.wires[0]?.closed).toBe(true);
});

test("a key in the address leaves the address bar, and only name and place are asked", async () => {
  const station = new Station(undefined, "http://station/#key=7k2q-aaaa-bbbb-cccc&tab=map");
  expect(station.url).toBe("http://station/#tab=map");
  expect(station.wires.length).toBe(0);
  await newest(station, "me").answer(STRANGER);
  await sayWho();
  await user.click(screen.getByRole("button", { name: "Entrar" }));
  expect(newest(station, "enter").body).toEqual({
    key: "7K2Q-AAAA-BBBB-CCCC",
    name: "Ana",
    place: "tableta",
  });
  await newest(station, "enter").answer(ANA);
  expect(station.wires.length).toBe(1);
  station.greet();
  expect(screen.getByRole("tab", { name: "Mapa 3D" }).getAttribute("aria-selected")).toBe("true");
});

test("who is in already needs no key: the one in the address stays unused", async () => {
  const station = new Station(undefined, "http://station/#key=7K2Q-AAAA-BBBB-CCCC");
  await newest(station, "me").answer({ ...ANA, kind: "local", role: "owner" });
  expect(station.wires.length).toBe(1);
  expect(station.askedAccess.map(({ path }) => path)).not.toContain("/api/v1/access/enter");
});

test.each([
  ["keeps none", () => vi.spyOn(window.navigator, "cookieEnabled", "get").mockReturnValue(false)],
  // As Chromium does where its user blocked them: it says that it keeps cookies, and forgets each.
  ["was told to keep none", () => vi.spyOn(document, "cookie", "set").mockImplementation(() => undefined)],
])("a browser that %s says so before a key is spent", async (_, forbid) => {
  forbid();
  const station = await stranger("http://station/#key=7K2Q-AAAA-BBBB-CCCC");
  expect(screen.getAllByText(/no guarda cookies/)[0]?.closest("[role=status]")).toBeTruthy();
  await sayWho();
  await user.click(screen.getByRole("button", { name: "Entrar" }));
  await user.click(screen.getByRole("button", { name: "Pedir entrar" }));
  expect(station.askedAccess.map(({ path }) => path)).toEqual(["/api/v1/access/me"]);
});

test("the cookie that tries whether cookies are kept is gone again", async () => {
  await stranger();
  expect(screen.queryByText(/no guarda cookies/)).toBeNull();
  expect(document.cookie).not.toContain("epf");
});

test("a cookie that was not kept is told apart from an access that has ended", async () => {
  const station = await stranger();
  await sayWho();
  await user.type(screen.getByRole("textbox", { name: "Clave de un solo uso" }), "aaaabbbbccccdddd{Enter}");
  await newest(station, "enter").answer(ANA);
  station.wires.at(-1)?.breakOff();
  await newest(station, "me").answer(STRANGER);
  expect(screen.getByRole("alert").textContent).toMatch(/no ha guardado la cookie/);
});

test("a wrong key says so and can be typed again", async () => {
  const station = await stranger("http://station/#key=WRON-GWRO-NGWR-ONGW");
  await sayWho();
  await user.click(screen.getByRole("button", { name: "Entrar" }));
  const problem = { code: "access_key_wrong", detail: "Not right.", params: {} };
  await newest(station, "enter").answer(problem, 401);
  expect(screen.getByRole("alert").textContent).toMatch(/Not right|no es correcta/);
  await user.type(
    screen.getByRole("textbox", { name: "Clave de un solo uso" }),
    "aaaa bbbb cccc dddd{Enter}",
  );
  expect(newest(station, "enter").body).toMatchObject({ key: "AAAA-BBBB-CCCC-DDDD" });
});

test("too many tries: the seconds are counted down, and nothing is sent before they are over", async () => {
  const station = await stranger();
  await sayWho();
  await user.type(screen.getByRole("textbox", { name: "Clave de un solo uso" }), "aaaabbbbccccdddd{Enter}");
  const tries = station.askedAccess.length;
  const problem = { code: "too_many_tries", detail: "Wait.", params: { retry_after_s: 3 } };
  await newest(station, "enter").answer(problem, 429);
  expect(screen.getByRole("timer").textContent).toContain("3 s");
  await user.click(screen.getByRole("button", { name: "Entrar" }));
  expect(station.askedAccess.length).toBe(tries);
  station.pass(1000);
  expect(screen.getByRole("timer").textContent).toContain("2 s");
  station.pass(2000);
  expect(screen.queryByRole("timer")).toBeNull();
  await user.click(screen.getByRole("button", { name: "Entrar" }));
  expect(station.askedAccess.length).toBe(tries + 1);
});

test("who asks to be let in waits, and is in as soon as the owner says yes", async () => {
  const station = await stranger();
  await sayWho();
  await user.click(screen.getByRole("button", { name: "Pedir entrar" }));
  expect(newest(station, "ask").body).toEqual({ name: "Ana", place: "tableta" });
  await newest(station, "ask").answer(WAITING);
  expect(screen.getByText("Esperando a que el dueño te deje entrar…")).toBeTruthy();
  station.pass(1600);
  await newest(station, "me").answer(WAITING);
  station.pass(1600);
  await newest(station, "me").answer(ANA);
  expect(station.wires.length).toBe(2);
  station.greet();
  expect(screen.getByRole("tab", { name: "Datos de vuelo" })).toBeTruthy();
});

test("who is not let in is told", async () => {
  const station = await stranger();
  await sayWho();
  await user.click(screen.getByRole("button", { name: "Pedir entrar" }));
  await newest(station, "ask").answer(WAITING);
  station.pass(1600);
  await newest(station, "me").answer(STRANGER);
  expect(screen.getByText(/No te han dejado entrar/)).toBeTruthy();
});

test("an ended person's page is out, says why, and forgets the name of its connection", async () => {
  const station = new Station();
  station.greet();
  await newest(station, "me").answer(ANA);
  station.breakOff();
  await newest(station, "me").answer(STRANGER);
  expect(screen.getByText(/Tu acceso ha terminado/)).toBeTruthy();
  expect(screen.queryByRole("tab", { name: "Datos de vuelo" })).toBeNull();
  expect(station.page.connection.getState().client).toBeNull();
  const dialled = station.wires.length;
  station.pass(20_000);
  expect(station.wires.length).toBe(dialled);
});

test("another role holds at once, without a new connection", async () => {
  const station = new Station();
  station.greet();
  await newest(station, "me").answer(ANA);
  const before = station.askedAccess.length;
  station.deliver({ type: "event", event: "access", t_s: 1, data: { role: "viewer", name: "Ana" } });
  expect(station.askedAccess.length).toBe(before + 1);
  await newest(station, "me").answer({ ...ANA, role: "viewer" });
  expect(station.page.admission.getState().role).toBe("viewer");
});

test("a station that does not answer is dialled on, and nobody is put out", async () => {
  const station = new Station();
  station.greet();
  await newest(station, "me").answer(ANA);
  station.breakOff();
  await newest(station, "me").answer("<html>", 502);
  station.pass(5000);
  expect(station.wires.length).toBeGreaterThan(1);
  expect(screen.getByRole("tab", { name: "Datos de vuelo" })).toBeTruthy();
});

test("only a page that came encrypted explains how a phone trusts the station", async () => {
  await stranger();
  expect(screen.queryByText(/avisó de que esta estación/)).toBeNull();
  cleanup();
  await stranger("https://station/");
  await user.click(screen.getByText(/avisó de que esta estación/));
  const download = screen.getByRole("link", { name: "Descargar el certificado" });
  expect(download.getAttribute("href")).toBe("/api/v1/access/authority");
});
