import { screen, within } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { beforeEach, expect, test } from "vitest";
import { aFlight, aFlightList } from "../../test/flights";
import { type FakeRequest, Station } from "../../test/station";
import { Tab } from "../../test/tab";

const user = userEvent.setup();
const MARK = {
  at_s: 61.5,
  t_s: 1_700_000_061.5,
  kind: "mark",
  name: "mark",
  id: "a1",
  data: { text: "viraje" },
  until_s: null,
};
let station: Station;

/** The newest question with this method about the flight's marks. */
function newest(method: string): FakeRequest {
  const asked = station.asked.filter((one) => one.method === method && /\/marks/.test(one.path)).at(-1);
  if (asked === undefined) throw new Error(`nothing was asked with ${method}`);
  return asked;
}

function story(): HTMLElement {
  return screen.getByRole("list", { name: "Qué pasó" });
}

function press(name: RegExp | string): Promise<void> {
  return user.click(screen.getByRole("button", { name }));
}

beforeEach(async () => {
  station = new Station(<Tab name="flights" />);
  station.greet();
  const flight = aFlight({ title: "Primera vuelta" });
  await station.asked
    .filter(({ path }) => path.startsWith("/api/v1/flights?"))
    .at(-1)
    ?.answer(aFlightList({ flights: [flight] }));
  await user.click(
    within(screen.getByRole("list", { name: "Vuelos grabados" })).getByRole("button", {
      name: /^Primera vuelta/,
    }),
  );
  await station.askedByBar
    .filter(({ path }) => path.endsWith(`${flight.id}/events`))
    .at(-1)
    ?.answer({ events: [MARK] });
});

test("a mark's words are changed in its place, and one press takes the change back", async () => {
  await press(/^Cambiar la marca de 1:01.5: viraje/);
  await user.keyboard("{Control>}a{/Control}pérdida{Enter}");
  expect(newest("PATCH").path).toMatch(/\/marks\/a1$/);
  expect(newest("PATCH").body).toEqual({ text: "pérdida" });
  await newest("PATCH").answer({ events: [{ ...MARK, data: { text: "pérdida" } }] });
  expect(story().textContent).toContain("pérdida");
  await press("Deshacer");
  expect(newest("PATCH").body).toEqual({ text: "viraje" });
  await newest("PATCH").answer({ events: [MARK] });
  expect(story().textContent).toContain("viraje");
  expect(screen.queryByRole("button", { name: "Deshacer" })).toBeNull();
});

test("a removed mark comes back with one press, at its moment", async () => {
  await press(/^Quitar la marca/);
  expect(newest("DELETE").path).toMatch(/\/marks\/a1$/);
  await newest("DELETE").answer({ events: [] });
  expect(screen.queryByText(/Marca quitada: viraje/)).not.toBeNull();
  await press("Deshacer");
  expect(newest("POST").body).toEqual({ text: "viraje", at_s: 61.5 });
});

test("Escape and empty words leave the mark as it was", async () => {
  for (const keys of ["otra{Escape}", "{Control>}a{/Control}{Delete}{Enter}"]) {
    await press(/^Cambiar la marca/);
    await user.keyboard(keys);
    expect(story().textContent).toContain("viraje");
  }
  expect(station.asked.filter(({ method }) => method === "PATCH")).toEqual([]);
});
