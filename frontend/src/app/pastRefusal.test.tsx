import { act, screen } from "@testing-library/react";
import { expect, test } from "vitest";
import { PLAYBACK } from "../features/playback/playbackRequests";
import { FLIGHT } from "../test/replay";
import { Station } from "../test/station";

test("a flight for which there is no place says why, once, however often the line is dialled again", () => {
  const station = new Station();
  station.greet();
  act(() => station.page.parts.get(PLAYBACK).openFlight(FLIGHT, 100));
  const refused = { code: "replays_own", detail: "x", params: { limit: 4 }, count: 1 };
  const kept = () => station.page.messages.getState().kept.filter(({ key }) => key === "problem.replays_own");
  for (let tries = 0; tries < 3; tries += 1) {
    station.replayed(({ wire }) => wire.deliver({ type: "event", event: "error", t_s: 0, data: refused }));
    station.replayed(({ wire }) => wire.breakOff());
    station.pass(5000);
  }
  expect(screen.getByText("Ya estás reproduciendo 4 grabaciones: cierra una primero.")).toBeTruthy();
  expect(kept()).toHaveLength(1);
  station.replayed((replay) => replay.greet());
  expect(station.shown().past).toBe(FLIGHT);
});
