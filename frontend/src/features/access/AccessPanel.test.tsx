import { screen, waitFor, within } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { expect, test } from "vitest";
import { type FakeRequest, Station } from "../../test/station";
import { Tab } from "../../test/tab";

const user = userEvent.setup();
const EVA = {
  id: "00000000000000e1",
  name: "Eva",
  place: "mesa 3",
  role: "viewer",
  state: "waiting",
  since_s: 1,
  seen_s: 1,
  address: "10.0.0.7",
  is_you: false,
  sessions: 1,
};

function newest(station: Station, method: string, path: string): FakeRequest {
  const found = station.askedAccess
    .filter((one) => one.method === method && one.path.startsWith(`/api/v1/access/${path}`))
    .at(-1);
  if (found === undefined) {
    throw new Error(`the page asked nothing with ${method} ${path}`);
  }
  return found;
}

async function setup(role: string, kind = "person", shown: "tab" | "window" = "tab"): Promise<Station> {
  const station = new Station(shown === "tab" ? <Tab name="setup" /> : undefined);
  station.greet();
  const me = { state: "in", kind, role, name: "Ana · tableta", anyone_may_fly: false };
  await newest(station, "GET", "me").answer(me);
  return station;
}

/** The tab in the whole window. */
async function inWindow(role: string): Promise<Station> {
  const station = await setup(role, "person", "window");
  await user.click(screen.getByRole("tab", { name: "Setup" }));
  return station;
}

async function lists(
  station: Station,
  people: readonly object[],
  sessions: readonly object[] = [],
): Promise<void> {
  await newest(station, "GET", "people").answer({ people });
  await newest(station, "GET", "sessions").answer({ sessions });
  await newest(station, "GET", "programs").answer({ programs: [] });
  await newest(station, "GET", "invitations").answer({ invitations: [] });
}

function panel(): HTMLElement {
  return screen.getByRole("region", { name: "Acceso" });
}

test("an operator sees who they are and may leave, and nothing of the others is asked", async () => {
  const station = await inWindow("operator");
  expect(panel().textContent).toContain("Has entrado como Ana · tableta. Tu papel: operador.");
  expect(within(panel()).queryByRole("tab", { name: "Personas" })).toBeNull();
  expect(new Set(station.askedAccess.map(({ path }) => path))).toEqual(new Set(["/api/v1/access/me"]));
  await user.click(within(panel()).getByRole("button", { name: "Salir" }));
  await user.click(within(screen.getByRole("alertdialog")).getByRole("button", { name: "Salir" }));
  await newest(station, "POST", "leave").answer({
    state: "stranger",
    kind: null,
    role: null,
    name: null,
    anyone_may_fly: false,
  });
  expect(screen.getByRole("heading", { name: "Entrar en la estación" })).toBeTruthy();
});

test("an owner sees who waits, and lets them in with a role", async () => {
  const station = await setup("owner");
  await lists(station, [EVA]);
  expect(within(panel()).getByRole("tab", { name: "Personas (1 espera)" })).toBeTruthy();
  await user.selectOptions(
    within(panel()).getByRole("combobox", { name: "Dejar entrar a Eva como" }),
    "operator",
  );
  await user.click(within(panel()).getByRole("button", { name: "Dejar entrar" }));
  expect(newest(station, "PATCH", `people/${EVA.id}`).body).toEqual({ state: "in", role: "operator" });
});

test("an invitation shows its key, address and code once", async () => {
  const station = await setup("owner", "local");
  await lists(station, []);
  await newest(station, "GET", "addresses").answer({ addresses: ["http://10.0.0.2:8000"], tls: false });
  await user.click(within(panel()).getByRole("tab", { name: "Invitar" }));
  await user.click(within(panel()).getByRole("button", { name: "Hacer una invitación" }));
  const asked = newest(station, "POST", "invitations");
  expect(asked.body).toEqual({ role: "viewer", minutes: 60, address: "http://10.0.0.2:8000" });
  await asked.answer({
    invitation: { id: "00000000000000a1", role: "viewer", since_s: 1, until_s: 3601 },
    key: "7K2Q-AAAA-BBBB-CCCC",
    address: "http://10.0.0.2:8000/#key=7K2Q-AAAA-BBBB-CCCC",
    qr_svg: "<svg/>",
  });
  expect(within(panel()).getByText("http://10.0.0.2:8000/#key=7K2Q-AAAA-BBBB-CCCC")).toBeTruthy();
  expect(
    within(panel())
      .getByRole("img", { name: /Código QR/ })
      .getAttribute("src"),
  ).toContain("data:image/svg+xml");
});

test("where no other device could follow an invitation there is no code of it, but what to do instead", async () => {
  const station = await setup("owner", "local");
  await lists(station, []);
  await newest(station, "GET", "addresses").answer({ addresses: [], tls: false });
  await user.click(within(panel()).getByRole("tab", { name: "Invitar" }));
  await user.click(within(panel()).getByRole("button", { name: "Hacer una invitación" }));
  const asked = newest(station, "POST", "invitations");
  expect(asked.body).toEqual({ role: "viewer", minutes: 60 });
  await asked.answer({
    invitation: { id: "00000000000000a1", role: "viewer", since_s: 1, until_s: 3601 },
    key: "7K2Q-AAAA-BBBB-CCCC",
    address: "http://127.0.0.1:8000/#key=7K2Q-AAAA-BBBB-CCCC",
    qr_svg: null,
  });
  const made = within(panel()).getByRole("region", { name: /^Invitación/ });
  expect(within(made).queryByRole("img")).toBeNull();
  expect(made.textContent).toContain("arranca la estación con --lan");
  expect(made.textContent).toContain("7K2Q-AAAA-BBBB-CCCC");
});

const ANA = { ...EVA, id: "00000000000000a1", name: "Ana", place: "tableta", role: "operator", state: "in" };

test("an owner ends somebody after being asked, and not by closing the question", async () => {
  const station = await setup("owner");
  await lists(station, [ANA]);
  const end = within(panel()).getByRole("button", { name: "Terminar el acceso de Ana · tableta" });
  await user.click(end);
  const asked = screen.getByRole("alertdialog");
  expect(asked.textContent).toContain("¿Terminar el acceso de Ana · tableta?");
  await user.click(within(asked).getByRole("button", { name: "Dejarlo" }));
  expect(station.askedAccess.some(({ method }) => method === "PATCH")).toBe(false);
  await user.click(end);
  await user.click(within(screen.getByRole("alertdialog")).getByRole("button", { name: "Terminar" }));
  const change = newest(station, "PATCH", `people/${ANA.id}`);
  expect(change.body).toEqual({ state: "ended" });
  const asks = () => station.askedAccess.filter(({ path }) => path === "/api/v1/access/people").length;
  const before = asks();
  await change.answer({ ...ANA, state: "ended", sessions: 0 });
  await waitFor(() => expect(asks()).toBe(before + 1));
  station.send({}); // all those answers took longer than a stream may be silent
  await lists(station, [{ ...ANA, state: "ended", sessions: 0 }]);
  expect(screen.queryByRole("alertdialog")).toBeNull();
  expect(within(panel()).queryByRole("button", { name: "Terminar el acceso de Ana · tableta" })).toBeNull();
  expect(within(panel()).getByText("terminado")).toBeTruthy();
  await user.click(within(panel()).getByRole("button", { name: "Quitar a Ana · tableta de la lista" }));
  expect(newest(station, "DELETE", `people/${ANA.id}`)).toBeTruthy();
});

test("an address and the certificate are shown as codes when asked for", async () => {
  const station = await setup("owner", "local");
  await lists(station, []);
  const address = "https://10.0.0.2:8000";
  await newest(station, "GET", "addresses").answer({ addresses: [address], tls: true });
  await newest(station, "GET", "certificates").answer({
    certificate: {
      kind: "made",
      names: ["pc.local"],
      addresses: ["10.0.0.2"],
      fingerprint: "AA:BB",
      since_s: 1,
      until_s: 2,
    },
    authority: { name: "EPF GCS pc.local", fingerprint: "CC:DD", until_s: 3 },
    fault: null,
  });
  await user.click(within(panel()).getByRole("tab", { name: "Direcciones y certificado" }));
  expect(within(panel()).queryByRole("img", { name: /Código QR/ })).toBeNull();
  await user.click(within(panel()).getByRole("button", { name: `Código QR de ${address}` }));
  const code = within(panel()).getByRole("img", { name: `Código QR de ${address}` });
  expect(code.getAttribute("src")).toBe(`/api/v1/access/code?address=${encodeURIComponent(address)}&to=page`);
  await user.click(within(panel()).getByRole("button", { name: "Código QR del certificado" }));
  const trusted = within(panel()).getByRole("img", { name: "Código QR de Descargar el certificado" });
  expect(trusted.getAttribute("src")).toContain("to=authority");
});

test("the log goes on where its last line stands, and lines that say the same are all shown", async () => {
  const station = await setup("owner");
  await lists(station, []);
  await user.click(within(panel()).getByRole("tab", { name: "Registro" }));
  const deed = { t_s: 5, name: "Ana", kind: "person", role: "operator", address: "10.0.0.7" };
  const same = { ...deed, deed: "command", what: "POST /commands/ahrs_on", result: "200" };
  const first = newest(station, "GET", "log");
  expect(new URLSearchParams(first.path.split("?")[1]).has("before")).toBe(false);
  await first.answer({
    deeds: Array.from({ length: 100 }, (_, row) => ({ ...same, at: 20_000 - 100 * row })),
  });
  await user.click(within(panel()).getByRole("button", { name: "Más antiguos" }));
  const second = newest(station, "GET", "log");
  expect(new URLSearchParams(second.path.split("?")[1]).get("before")).toBe("10100");
  await second.answer({ deeds: [{ ...same, at: 300 }] });
  expect(within(panel()).getAllByRole("row", { name: /ahrs_on/ })).toHaveLength(101);
  expect(within(panel()).queryByRole("button", { name: "Más antiguos" })).toBeNull();
});

test("the log says who was no person, what was refused, and that nothing was found", async () => {
  const station = await setup("owner");
  await lists(station, []);
  await user.click(within(panel()).getByRole("tab", { name: "Registro" }));
  const deed = {
    t_s: 5,
    name: "",
    address: "10.0.0.7",
    deed: "command",
    what: "",
    result: "403",
    role: null,
  };
  await newest(station, "GET", "log").answer({
    deeds: [
      { ...deed, at: 30, kind: "stranger" },
      { ...deed, at: 20, kind: "local", role: "owner", what: "POST /commands/reset" },
      { ...deed, at: 10, kind: "person", name: "Ana", role: "viewer" },
      { ...deed, at: 5, kind: "local", deed: "holder", what: "- > this computer 2", result: "waited" },
    ],
  });
  const cells = (column: number) =>
    within(panel())
      .getAllByRole("row")
      .slice(1)
      .map((row) => within(row).getAllByRole("cell")[column]?.textContent);
  const here = "el ordenador de la estación";
  expect(cells(1)).toEqual(["un desconocido", here, "Ana (espectador)", here]);
  expect(cells(3).at(-1)).toBe(`el control cambió: nadie › ${here} 2`);
  const search = within(panel()).getByRole("textbox", { name: "Buscar en el registro" });
  await user.type(search, "nobody{Enter}");
  await newest(station, "GET", "log").answer({ deeds: [] });
  expect(within(panel()).getByText("No hay nada que mostrar.")).toBeTruthy();
});

test("one browser of somebody is put out only after a question", async () => {
  const station = await setup("owner");
  const session = {
    id: "00000000000000b1",
    person: ANA.id,
    name: "Ana · tableta",
    since_s: 1,
    seen_s: 1,
    address: "10.0.0.7",
    is_you: false,
  };
  await lists(station, [ANA], [session]);
  const end = within(panel()).getByRole("button", {
    name: "Terminar la sesión de Ana · tableta desde 10.0.0.7",
  });
  await user.click(end);
  await user.click(within(screen.getByRole("alertdialog")).getByRole("button", { name: "Dejarlo" }));
  expect(station.askedAccess.some(({ method }) => method === "DELETE")).toBe(false);
  await user.click(end);
  const asked = screen.getByRole("alertdialog");
  expect(asked.textContent).toContain("¿Terminar esta sesión de Ana · tableta?");
  expect(asked.textContent).toContain("Solo este navegador (10.0.0.7)");
  await user.click(within(asked).getByRole("button", { name: "Terminar" }));
  expect(newest(station, "DELETE", `sessions/${session.id}`).path).toBe(
    `/api/v1/access/sessions/${session.id}`,
  );
});

test("a program's key is made with a name, shown once, and ended only after a question", async () => {
  const station = await setup("owner");
  await lists(station, []);
  await user.click(within(panel()).getByRole("tab", { name: "Programas" }));
  expect(within(panel()).getByText("Ningún programa tiene clave.")).toBeTruthy();
  const make = within(panel()).getByRole("button", { name: "Hacer una clave" });
  expect(make.getAttribute("aria-disabled")).toBe("true");
  await user.type(within(panel()).getByRole("textbox", { name: "Nombre del programa" }), "registro");
  await user.click(make);
  const asked = newest(station, "POST", "programs");
  expect(asked.body).toEqual({ name: "registro", role: "viewer" });
  const program = { id: "00000000000000f1", name: "registro", role: "viewer", since_s: 1, seen_s: null };
  await asked.answer({ key: "epf_0123456789", program });
  await newest(station, "GET", "programs").answer({ programs: [program] });
  expect(within(panel()).getByText("epf_0123456789")).toBeTruthy();
  expect(within(panel()).getByText("nunca")).toBeTruthy();
  const end = within(panel()).getByRole("button", { name: "Terminar el acceso de registro" });
  await user.click(end);
  await user.keyboard("{Escape}");
  expect(station.askedAccess.some(({ method }) => method === "DELETE")).toBe(false);
  await user.click(end);
  await user.click(within(screen.getByRole("alertdialog")).getByRole("button", { name: /^Terminar/ }));
  expect(newest(station, "DELETE", `programs/${program.id}`)).toBeDefined();
});

test("a tab is brought to a tablet by an address that a tablet can open; where this page has none, it says so", async () => {
  const station = await inWindow("operator");
  const open = async (): Promise<HTMLElement> => {
    await user.click(screen.getByRole("menuitem", { name: "Ver" }));
    await user.click(await screen.findByRole("menuitem", { name: /^Abrir esta pestaña/ }));
    return await screen.findByRole("dialog");
  };
  station.url = "http://127.0.0.1:8000/";
  expect((await open()).textContent).toContain("solo vale en este ordenador");
  expect(within(screen.getByRole("dialog")).queryByText(/127\.0\.0\.1/)).toBeNull();
  await user.keyboard("{Escape}");
  station.url = "http://10.0.0.2:8000/";
  expect((await open()).textContent).toContain("http://10.0.0.2:8000/#tab=setup");
});
