import { screen, within } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { expect, test } from "vitest";
import { aStatus } from "../../test/aStatus";
import { aFlightEvent } from "../../test/flights";
import { type FakeRequest, Station } from "../../test/station";

const user = userEvent.setup();
const EVENTS = "/api/v1/flights/current/events";

function asked(station: Station): readonly FakeRequest[] {
  return station.askedByBar.filter(({ path }) => path === EVENTS);
}

function lines(): readonly (string | null)[] {
  return screen
    .getAllByRole("listitem")
    .filter((line) => line.className === "log-line")
    .map((line) => line.querySelector(".log-text")?.textContent ?? null);
}

async function opened(): Promise<Station> {
  const station = new Station();
  station.greet();
  station.page.messages.say({ level: "error", key: "said.malformed", params: {} });
  await user.click(screen.getByRole("button", { name: "Abrir el registro de mensajes" }));
  await screen.findByRole("searchbox", { name: "Buscar en el registro" });
  return station;
}

test("the log opens from the last message and tells what was said and what was recorded", async () => {
  const station = await opened();
  expect(lines()).toHaveLength(1);
  const said_s = (station.page.messages.getState().last?.said_ms ?? 0) / 1000;
  await asked(station)
    .at(-1)
    ?.answer({
      events: [aFlightEvent({ kind: "mark", t_s: said_s - 60, data: { text: "primer viraje" } })],
    });
  expect(lines()).toHaveLength(2);
  expect(lines()[1]).toContain("primer viraje");
  expect(screen.getByText("2 líneas")).toBeTruthy();
  await user.type(screen.getByRole("searchbox", { name: "Buscar en el registro" }), "viraje");
  expect(lines()).toHaveLength(1);
  await user.clear(screen.getByRole("searchbox", { name: "Buscar en el registro" }));
  await user.click(screen.getByRole("button", { name: "Mensajes", pressed: true }));
  expect(lines()).toEqual([expect.stringContaining("primer viraje")]);
  await user.click(screen.getByRole("button", { name: "Mostrar todo" }));
  expect(lines()).toHaveLength(2);
});

test("a log that cannot be read says why, and what the page said stays", async () => {
  const station = await opened();
  await asked(station)
    .at(-1)
    ?.answer({ code: "recording_unreadable", detail: "x", params: { reason: "sin cabecera" } }, 409);
  expect(lines()).toHaveLength(1);
  expect(within(screen.getByRole("dialog")).getByText(/sin cabecera/)).toBeTruthy();
});

test("without a recording it says that only this page's words are here, and asks nothing", async () => {
  const station = new Station();
  const status = aStatus();
  station.greet({ ...status, recording: { ...status.recording, active: false, file: null } });
  await user.click(screen.getByRole("button", { name: "Abrir el registro de mensajes" }));
  await screen.findByText(/No se está grabando/);
  expect(asked(station)).toEqual([]);
});
