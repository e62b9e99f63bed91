import { screen, within } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { expect, test } from "vitest";
import { aStatus } from "../../test/aStatus";
import { type FakeRequest, Station } from "../../test/station";

const user = userEvent.setup();
const LINES = [
  { text: "Hélice", watched: null },
  { text: "Sin alarmas", watched: "alarms" },
];

function newest(station: Station, method: string): FakeRequest {
  const found = station.asked
    .filter((one) => one.method === method && one.path === "/api/v1/checklist")
    .at(-1);
  if (found === undefined) throw new Error(`nothing was asked with ${method}`);
  return found;
}

async function opened(lines: readonly object[] | null): Promise<Station> {
  const station = new Station();
  station.greet();
  await user.click(screen.getByRole("menuitem", { name: "Ver" }));
  await user.click(await screen.findByRole("menuitem", { name: "Lista antes del despegue" }));
  await screen.findByRole("dialog", { name: "Lista antes del despegue" });
  await newest(station, "GET").answer({ lines });
  return station;
}

const box = (name: string): HTMLInputElement =>
  screen.getByRole("checkbox", { name: new RegExp(`^${name}`) });

test("a person ticks a line, and a line that the station watches is the station's", async () => {
  await opened(LINES);
  expect([box("Hélice").checked, box("Sin alarmas").checked]).toEqual([false, true]);
  await user.click(box("Hélice"));
  await user.click(box("Sin alarmas"));
  expect([box("Hélice").checked, box("Sin alarmas").checked]).toEqual([true, true]);
  expect(screen.getByText("Todo hecho: lista para despegar.")).toBeTruthy();
  await user.click(screen.getByRole("button", { name: "Empezar de nuevo" }));
  expect(box("Hélice").checked).toBe(false);
  expect(screen.getByText("1 de 2 hechas")).toBeTruthy();
});

test("what the station does not see any more is not ticked: an alarm, and a gateway that is gone", async () => {
  const station = await opened(LINES);
  const alarm = {
    id: "battery_low",
    level: "warning",
    since_s: 1_700_000_000,
    until_s: null,
    text: "Low.",
    params: { battery_v: 9.8 },
    acknowledged: false,
    count: 1,
  } as const;
  station.status(aStatus({ alarms: [alarm] }));
  await expect.poll(() => box("Sin alarmas").checked).toBe(false);
  station.status(aStatus());
  await expect.poll(() => box("Sin alarmas").checked).toBe(true);
  station.breakOff();
  await expect.poll(() => box("Sin alarmas").checked).toBe(false);
});

test("without a list of their own everybody has the page's, in its language", async () => {
  await opened(null);
  expect(screen.getAllByRole("checkbox").length).toBeGreaterThan(8);
  expect(box("Mandos libres y en el sentido correcto").checked).toBe(false);
});

test("the list is edited as a whole and kept in the station; what is empty is left out", async () => {
  const station = await opened(LINES);
  await user.click(screen.getByRole("button", { name: "Editar" }));
  await user.click(screen.getByRole("button", { name: "Añadir una línea" }));
  await user.click(screen.getByRole("button", { name: "Añadir una línea" }));
  const third = screen.getByRole("textbox", { name: "Texto de la línea 3" });
  await user.type(third, "Viento{Enter}");
  await user.click(screen.getByRole("button", { name: "Subir «Viento»" }));
  await user.click(screen.getByRole("button", { name: "Quitar «Hélice»" }));
  await user.click(screen.getByRole("button", { name: "Guardar" }));
  expect(newest(station, "PUT").body).toEqual({
    lines: [
      { text: "Viento", watched: null },
      { text: "Sin alarmas", watched: "alarms" },
    ],
  });
  await newest(station, "PUT").answer({ lines: [{ text: "Viento", watched: null }] });
  expect(screen.getAllByRole("checkbox")).toHaveLength(1);
});

test("a list that cannot be kept says why and stays open; one that somebody else changed says so", async () => {
  const station = await opened(LINES);
  await user.click(screen.getByRole("button", { name: "Editar" }));
  station.deliver({ type: "event", event: "checklist", t_s: 1_700_000_000, data: {} });
  const dialog = screen.getByRole("dialog");
  expect(within(dialog).getByText(/Otra persona ha cambiado la lista/)).toBeTruthy();
  await user.click(screen.getByRole("button", { name: "Guardar" }));
  const params = { reason: "disco lleno" };
  await newest(station, "PUT").answer({ code: "checklist_not_kept", detail: "x", params }, 409);
  expect(within(dialog).getByText(/disco lleno/)).toBeTruthy();
  expect(screen.getByRole("textbox", { name: "Texto de la línea 1" })).toBeTruthy();
});
