import { act } from "@testing-library/react";
import { expect, test } from "vitest";
import type { StoreApi } from "zustand/vanilla";
import { ACCESS_ADMIN } from "../features/access/accessAdmin";
import { CONTROL_PAGES } from "../features/access/controlPages";
import { FLIGHTS } from "../features/flights/flightLibrary";
import { GAMEPADS } from "../features/gamepad/gamepadList";
import { TRACK_LOG } from "../features/map/track/trackLog";
import { PLAYBACK } from "../features/playback/playbackRequests";
import { Station } from "../test/station";

/** Throws at its first call, and counts all of them. */
function throwing(): { readonly call: () => void; readonly calls: () => number } {
  let calls = 0;
  return {
    call: () => {
      calls += 1;
      if (calls === 1) {
        throw new Error("the first turn");
      }
    },
    calls: () => calls,
  };
}

test.each(["movement", "text"] as const)("a painter of %s that throws is painted again", (rate) => {
  const station = new Station(<p />);
  station.greet();
  const painter = throwing();
  act(() => void station.page.pump.add(rate, painter.call));
  station.show();
  station.send({ ahrs: { roll_deg: 1 } });
  expect(painter.calls()).toBeGreaterThan(1);
  expect(station.reported).toHaveLength(1);
});

test("who follows the stick and throws is called again", () => {
  const station = new Station(<p />);
  station.greet();
  const follower = throwing();
  act(() => void station.page.parts.get(GAMEPADS).watch(follower.call));
  station.pass(100);
  expect(follower.calls()).toBeGreaterThan(1);
  expect(station.reported).toHaveLength(1);
});

test("a listener of the connection that throws does not keep the line from its next dial", () => {
  const station = new Station(<p />);
  station.greet();
  const listener = throwing();
  station.page.connection.subscribe(listener.call);
  station.breakOff();
  station.pass(1000);
  expect(station.wires.length).toBeGreaterThan(1);
  station.greet();
  expect(station.page.connection.getState().phase).toBe("open");
  expect(station.reported).toHaveLength(1);
});

interface Watched {
  readonly store: Pick<StoreApi<unknown>, "subscribe">;
  readonly watch: () => () => void;
}

test.each<[string, string, (station: Station) => Watched]>([
  ["pages", "/api/v1/control", ({ page }) => page.parts.get(CONTROL_PAGES)],
  ["people", "/api/v1/access/people", ({ page }) => page.parts.get(ACCESS_ADMIN)],
  ["flights", "/api/v1/flights?", ({ page }) => page.parts.get(FLIGHTS)],
  ["tracks", "/api/v1/track/points?source=flight", ({ page }) => page.parts.get(TRACK_LOG)],
  ["the time bar's flight", "/api/v1/flights/current/overview", ({ page }) => page.parts.get(PLAYBACK).facts],
])("what is read of %s is read again after a viewer that throws", async (_, path, watchedBy) => {
  const station = new Station(<p />);
  station.greet();
  const { store, watch } = watchedBy(station);
  const viewer = throwing();
  store.subscribe(viewer.call);
  const asked = () => [...station.asked, ...station.askedAccess, ...station.askedByBar];
  const rounds = () => asked().filter((question) => question.path.startsWith(path)).length;
  act(() => void watch());
  const answered = new Set<unknown>();
  for (let next = asked()[0]; next !== undefined; next = asked().find((one) => !answered.has(one))) {
    answered.add(next);
    await next.answer({}, 500);
  }
  expect(viewer.calls()).toBeGreaterThan(0);
  expect(station.reported).toHaveLength(1);
  const before = rounds();
  station.pass(60_000);
  expect(rounds()).toBeGreaterThan(before);
});
