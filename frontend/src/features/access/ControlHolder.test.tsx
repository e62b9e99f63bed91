import { screen, within } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { expect, test } from "vitest";
import { aStatus, heldBy } from "../../test/aStatus";
import { type FakeRequest, Station } from "../../test/station";

const user = userEvent.setup();

async function admitted(role: string, control = aStatus().control, extra: object = {}): Promise<Station> {
  const station = new Station();
  station.greet(aStatus({ control }));
  const me = { state: "in", kind: "person", role, name: "Ana", anyone_may_fly: false, ...extra };
  await station.askedAccess.at(-1)?.answer(me);
  return station;
}

function newest(station: Station): FakeRequest {
  const asked = station.asked.at(-1);
  if (asked === undefined) {
    throw new Error("the page asked nothing");
  }
  return asked;
}

function asking(client: string, name: string, given_at_s: number | null) {
  return {
    client,
    name,
    kind: "person" as const,
    number: 1,
    role: "operator" as const,
    since_s: 1,
    given_at_s,
  };
}

test("an operator asks whoever has control, sees the seconds that are left, and may withdraw", async () => {
  const station = await admitted("operator", heldBy("c2", "Luis · portátil"));
  expect(screen.getByText("El control lo tiene Luis · portátil")).toBeTruthy();
  await user.click(screen.getByRole("button", { name: "Pedir el control" }));
  expect(newest(station)).toMatchObject({ path: "/api/v1/control", body: { client: "c1", action: "ask" } });
  const now_s = 1_700_000_000 + station.timers.now_ms() / 1000;
  station.status(
    aStatus({ control: { ...heldBy("c2", "Luis"), requests: [asking("c1", "Ana", now_s + 8)] } }),
  );
  expect(screen.getByText(/es tuyo en \d+ s/)).toBeTruthy();
  await user.click(screen.getByRole("button", { name: "Retirar" }));
  expect(newest(station).body).toEqual({ client: "c1", action: "withdraw" });
});

test("a request that only the holder answers shows no seconds on either page", async () => {
  const station = await admitted("operator", heldBy("c2", "Luis"));
  station.status(aStatus({ control: { ...heldBy("c2", "Luis"), requests: [asking("c1", "Ana", null)] } }));
  expect(screen.getByText("Pedido: lo da quien lo tiene, o un dueño.")).toBeTruthy();
  expect(screen.getByRole("button", { name: "Retirar" })).toBeTruthy();
  station.status(aStatus({ control: { ...aStatus().control, requests: [asking("c2", "Luis", null)] } }));
  const band = screen.getByRole("status", { name: "Peticiones de control" });
  expect(band.textContent).toContain("Sigues teniéndolo hasta que contestes.");
});

test("only an owner takes control at once, after a question that names whom it hits", async () => {
  await admitted("operator", heldBy("c2", "Luis"));
  expect(screen.queryByRole("button", { name: "Tomarlo ya" })).toBeNull();
});

test("an owner's question is answered before anything is sent", async () => {
  const station = await admitted("owner", heldBy("c2", "Luis"));
  await user.click(screen.getByRole("button", { name: "Tomarlo ya" }));
  const dialog = screen.getByRole("alertdialog");
  expect(dialog.textContent).toContain("Luis tiene el control ahora");
  expect(station.asked).toEqual([]);
  await user.click(within(dialog).getByRole("button", { name: "Tomar el control" }));
  expect(newest(station).body).toEqual({ client: "c1", action: "take", confirm: true });
});

test("an owner's question stays while the holder is lost and comes back", async () => {
  const station = await admitted("owner", heldBy("c2", "Luis"));
  await user.click(screen.getByRole("button", { name: "Tomarlo ya" }));
  const confirm = within(screen.getByRole("alertdialog")).getByRole("button", { name: "Tomar el control" });
  station.status(aStatus({ control: heldBy(null, null) }));
  station.status(aStatus({ control: heldBy("c2", "Luis") }));
  await user.click(confirm);
  expect(newest(station).body).toEqual({ client: "c1", action: "take", confirm: true });
});

test("a request is a band on the holder's page that takes no focus, with both answers", async () => {
  const station = await admitted("operator");
  const focused = document.activeElement;
  const control = { ...aStatus().control, requests: [asking("c2", "Luis · portátil", 1_700_000_009)] };
  station.status(aStatus({ control }));
  const band = screen.getByRole("status", { name: "Peticiones de control" });
  expect(band.textContent).toContain("Luis · portátil pide el control.");
  expect(document.activeElement).toBe(focused);
  expect(screen.queryByRole("dialog")).toBeNull();
  await user.click(within(band).getByRole("button", { name: "Dárselo" }));
  expect(newest(station).body).toEqual({ client: "c1", action: "grant", to: "c2" });
  await newest(station).answer({ client: "c2" });
  await user.click(within(band).getByRole("button", { name: "No" }));
  expect(newest(station).body).toEqual({ client: "c1", action: "refuse", to: "c2" });
});

test("a request is no band on a page that only watches", async () => {
  const control = { ...heldBy("c2", "Luis"), requests: [asking("c3", "Eva", 1)] };
  await admitted("operator", control);
  expect(screen.getByRole("status", { name: "Peticiones de control" }).textContent).toBe("");
});

test("a viewer's buttons say that the role does not allow it", async () => {
  await admitted("viewer", heldBy(null, null));
  const take = screen.getByRole("button", { name: "Tomar el control" });
  expect(take.getAttribute("aria-disabled")).toBe("true");
  const autopilot = screen.getByRole("group", { name: "Autopilot" });
  expect(within(autopilot).getByText(/Tu papel es mirar/)).toBeTruthy();
});

test("a page on the station's own computer is called so in the user's language", async () => {
  const holder = { ...heldBy("c2", "this computer"), kind: "local" as const, number: 2 };
  await admitted("operator", holder);
  expect(screen.getByText("El control lo tiene el ordenador de la estación 2")).toBeTruthy();
});

test("while anyone may fly without a key a red band says so", async () => {
  await admitted("operator", heldBy(null, null), { anyone_may_fly: true });
  expect(screen.getByText(/Cualquiera de esta red puede volar sin clave/).className).toBe("app-open-door");
});

test("a newer version of the page is offered and loaded only when it is wanted", async () => {
  const station = await admitted("operator");
  let loads = 0;
  station.offer(() => {
    loads += 1;
  });
  expect(loads).toBe(0);
  await user.click(screen.getByRole("button", { name: "Cargarla ahora" }));
  expect(loads).toBe(1);
});
