import { expect, test } from "vitest";
import { readFlightName } from "./flightName";

const STARTED_S = Date.UTC(2026, 10, 26, 9, 32, 43) / 1000;

test.each([
  ["data/recordings/20261126T093243Z.mcap", "20261126T093243Z"],
  ["20261126T093243Z-2", "20261126T093243Z-2"],
])("%s is named by the second in which it began", (text, id) => {
  expect(readFlightName(text)).toEqual({ id, started_s: STARTED_S });
});

test.each(["current", "data/recordings/flight.mcap", "20261126T093243Z.csv"])("%s has no moment", (text) => {
  expect(readFlightName(text)).toBeNull();
});
