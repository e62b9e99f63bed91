import { screen, within } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { beforeEach, expect, test } from "vitest";
import type { Job } from "../../protocol/guards.gen";
import { aJob } from "../../test/flights";
import { type FakeRequest, Station } from "../../test/station";
import { Tab } from "../../test/tab";
import { passwordFault } from "./backups";

const user = userEvent.setup();
const PASSWORD = "correct horse battery";

let station: Station;

function newest(method: string, path: string): FakeRequest {
  const found = station.asked.filter((one) => one.method === method && one.path === path).at(-1);
  if (found === undefined) {
    throw new Error(`the page asked nothing with ${method} ${path}`);
  }
  return found;
}

function panel(): HTMLElement {
  return screen.getByRole("region", { name: "Acceso" });
}

function make(): HTMLElement {
  return within(panel()).getByRole("button", { name: "Hacer una copia" });
}

async function type(password: string, again: string): Promise<void> {
  await user.type(within(panel()).getByLabelText("Contraseña"), password);
  await user.type(within(panel()).getByLabelText("La misma otra vez"), again);
}

async function told(...jobs: ReadonlyArray<Partial<Job>>): Promise<void> {
  const backups = jobs.map((parts) => aJob({ kind: "backup", flight: null, file: null, ...parts }));
  await newest("GET", "/api/v1/jobs").answer({ jobs: [aJob(), ...backups] });
}

/** Time passes, and the gateway is heard all the while. */
function listenFor(duration_s: number): void {
  for (let passed_s = 0; passed_s < duration_s; passed_s += 0.5) {
    station.send({});
    station.pass(500);
  }
}

beforeEach(async () => {
  station = new Station(<Tab name="setup" />);
  station.greet();
  const me = { state: "in", kind: "person", role: "owner", name: "Ana", anyone_may_fly: false };
  await station.askedAccess
    .filter(({ path }) => path.endsWith("/me"))
    .at(-1)
    ?.answer(me);
  await user.click(within(panel()).getByRole("tab", { name: "Copia de seguridad" }));
});

test("a backup is begun with the password typed twice, shows how far it is, and is there to be fetched", async () => {
  await told();
  await type(PASSWORD, PASSWORD);
  await user.click(make());
  const asked = newest("POST", "/api/v1/backups");
  expect(asked.body).toEqual({ password: PASSWORD });
  await asked.answer({ job: "0123456789ab" }, 202);
  await told({ state: "running", progress: 0.25 });
  expect(within(panel()).getByRole("progressbar").getAttribute("value")).toBe("0.25");
  expect((within(panel()).getByLabelText("Contraseña") as HTMLInputElement).value, "it is kept nowhere").toBe(
    "",
  );
  listenFor(1);
  await told({
    state: "done",
    progress: 1,
    result: { name: "epf-gcs-20231114T100000Z.tar.age", bytes: 12_300_000 },
  });
  const link = within(panel()).getByRole("link", {
    name: "Descargar epf-gcs-20231114T100000Z.tar.age (12.3 MB)",
  });
  expect(link.getAttribute("href")).toBe("/api/v1/jobs/0123456789ab/result");
  const before = station.asked.length;
  listenFor(5);
  expect(station.asked.slice(before).filter(({ path }) => path === "/api/v1/jobs")).toEqual([]);
});

test("a password that is too short, or not the same twice, is said at its field and not sent", async () => {
  await told();
  await type("corta", "otra");
  expect(panel().textContent).toContain("La contraseña necesita 10 caracteres o más");
  await user.click(make());
  await user.type(within(panel()).getByLabelText("Contraseña"), " pero ya no");
  expect(panel().textContent).toContain("Las dos no son iguales.");
  await user.click(make());
  expect(station.asked.filter(({ path }) => path === "/api/v1/backups")).toEqual([]);
});

test.each([
  [
    "backup_disk_full",
    { needed_mb: 900, free_mb: 700, reserve_mb: 500 },
    "necesita 900 MB: hay 700 MB libres",
  ],
  ["backup_not_written", { why: "Permission denied" }, "No se ha podido escribir la copia de seguridad"],
])("a backup that failed with %s says why", async (code, params, words) => {
  await told({ state: "failed", fault: { code, detail: "x", params } as Job["fault"] });
  expect(within(panel()).getByRole("alert").textContent).toContain("No se ha hecho la copia de seguridad.");
  expect(within(panel()).getByRole("alert").textContent).toContain(words);
});

test("who is an owner no more is told so", async () => {
  await told();
  await type(PASSWORD, PASSWORD);
  await user.click(make());
  await newest("POST", "/api/v1/backups").answer(
    { code: "role_too_low", detail: "x", params: { least: "owner", role: "viewer" } },
    403,
  );
  expect(within(panel()).getByRole("alert").textContent).toContain("pídelo a un propietario");
  expect((within(panel()).getByLabelText("Contraseña") as HTMLInputElement).value).toBe(PASSWORD);
});

test("a backup under way can be cancelled, and no second one begins beside it", async () => {
  await told({ state: "running", progress: 0.5 });
  await type(PASSWORD, PASSWORD);
  await user.click(make());
  expect(station.asked.filter(({ path }) => path === "/api/v1/backups")).toEqual([]);
  await user.click(within(panel()).getByRole("button", { name: "Cancelar la copia" }));
  await newest("DELETE", "/api/v1/jobs/0123456789ab").answer(aJob({ kind: "backup", state: "cancelled" }));
  await told({ state: "cancelled" });
  expect(within(panel()).queryByRole("progressbar")).toBeNull();
});

test("characters are counted as the station counts them", () => {
  expect(passwordFault("🛩".repeat(10), "🛩".repeat(10))).toBeNull();
  expect(passwordFault("x".repeat(201), "x".repeat(201))).toBe("long");
  expect(passwordFault("two\u200blines of it", "two\u200blines of it")).toBe("unprintable");
  expect(passwordFault("con espacio", "con espacio")).toBeNull();
});
