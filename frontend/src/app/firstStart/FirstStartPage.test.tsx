import { screen, within } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { expect, test } from "vitest";
import { aStatus } from "../../test/aStatus";
import { type FakeRequest, Station } from "../../test/station";

const user = userEvent.setup();
const closed = aStatus({
  board: { ...aStatus().board, state: "closed", url: null, mode: null, firmware: null },
  simulator: { ...aStatus().simulator, state: "closed" },
});

async function load(role: string, status = closed): Promise<Station> {
  const station = new Station();
  station.greet(status);
  const me = { state: "in", kind: "local", role, name: "local", anyone_may_fly: false };
  await station.askedAccess
    .filter(({ path }) => path.endsWith("/me"))
    .at(-1)
    ?.answer(me);
  return station;
}

function questions(station: Station): readonly FakeRequest[] {
  return station.asked.filter(({ path }) => path === "/api/v1/first-start");
}

async function shown(): Promise<Station> {
  const station = await load("owner");
  await questions(station)[0]?.answer({ is_due: true });
  await screen.findByRole("heading", { name: "Prepara esta estación" });
  return station;
}

function isThere(): boolean {
  return screen.queryByRole("heading", { name: "Prepara esta estación" }) !== null;
}

test("an owner of a new station is led through four steps, and the station is told at the end", async () => {
  const station = await shown();
  await user.click(within(screen.getByRole("main")).getByRole("radio", { name: "English" }));
  await user.click(screen.getByRole("button", { name: "Next" }));
  expect(document.activeElement?.textContent).toBe("Step 2 of 4: Board");
  expect(screen.getByRole("combobox", { name: "Port" })).toBeDefined();
  await user.click(screen.getByRole("button", { name: "Skip this step" }));
  expect(screen.getByRole("textbox", { name: "X-Plane IP" })).toBeDefined();
  await user.click(screen.getByRole("button", { name: "Back" }));
  station.status({ ...closed, board: aStatus().board });
  await user.click(screen.getByRole("button", { name: "Next" }));
  await user.click(screen.getByRole("button", { name: "Skip this step" }));
  expect(document.activeElement?.textContent).toBe("Step 4 of 4: Key");
  await user.click(screen.getByRole("button", { name: "Done" }));
  expect(isThere()).toBe(false);
  expect(questions(station).map(({ method }) => method)).toEqual(["GET", "DELETE"]);
});

test("later hides it at once, and says so if the station does not keep that", async () => {
  const station = await shown();
  await user.click(screen.getByRole("button", { name: "Más tarde" }));
  expect(isThere()).toBe(false);
  const problem = { code: "first_start_not_kept", detail: "x", params: { reason: "disk full" } };
  await questions(station)[1]?.answer(problem, 507);
  expect(screen.getAllByText(/No se puede guardar que el primer arranque/).length).toBeGreaterThan(0);
});

test("a tab that is chosen hides it, and the station is told nothing", async () => {
  const station = await shown();
  station.openTab("setup");
  expect(isThere()).toBe(false);
  expect(questions(station)).toHaveLength(1);
});

test("a station that was set up, or does not say, shows its tabs", async () => {
  for (const [answer, status] of [
    [{ is_due: false }, 200],
    [{ code: "internal", detail: "x", params: {} }, 500],
  ] as const) {
    const station = await load("owner");
    await questions(station)[0]?.answer(answer, status);
    expect(isThere()).toBe(false);
  }
});

test("it is asked once, and neither for others than owners nor while a board is open", async () => {
  const station = await load("owner");
  station.status(closed);
  expect(questions(station)).toHaveLength(1);
  expect(questions(await load("operator"))).toEqual([]);
  const flying = await load("owner", aStatus());
  flying.status(closed);
  expect(questions(flying)).toEqual([]);
});
