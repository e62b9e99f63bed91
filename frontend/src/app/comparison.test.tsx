import { screen } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { expect, test } from "vitest";
import { FLIGHT_COMPARISON } from "../features/flights/flightComparison";
import { PLOTS } from "../features/plots/plots";
import { aStatus } from "../test/aStatus";
import { aFlight, aFlightList } from "../test/flights";
import { Station } from "../test/station";

const user = userEvent.setup();
const FIRST = aFlight();
const SECOND = aFlight({ id: "20231113T090000Z", started_s: 1_699_866_000, title: "Segunda" });

test("the plots of two flights open on their tab, and the page of the past can compare as well", async () => {
  const station = new Station();
  station.greet(aStatus());
  await user.click(screen.getByRole("tab", { name: "Vuelos" }));
  station.show();
  const list = station.asked.filter(({ path }) => /\/flights\?.*sort=/.test(path)).at(-1);
  await list?.answer(aFlightList({ flights: [FIRST, SECOND] }));
  await user.click(screen.getByRole("checkbox", { name: "Comparar Segunda" }));
  await user.click(screen.getByRole("checkbox", { name: "Comparar Primera vuelta" }));
  await user.click(screen.getByRole("button", { name: "Gráficas de ambos" }));
  station.replayed((replay) => replay.greet());
  expect(screen.getByRole("tab", { name: "Gráficas" }).getAttribute("aria-selected")).toBe("true");
  expect(station.shown().past).toBe(SECOND.id);
  const { parts } = station.shown();
  expect(parts.get(PLOTS).store.getState().compared).toBe(FIRST.id);
  expect(parts.get(FLIGHT_COMPARISON).views.getState()).toHaveLength(2);
});
