import { act, fireEvent } from "@testing-library/react";
import { expect, test } from "vitest";
import { Station } from "../../test/station";
import { PLAYBACK } from "./playbackRequests";

test("the arrows are left to a list that has the focus, and with Shift they are the speed from there too", () => {
  const station = new Station();
  station.greet();
  act(() => station.page.parts.get(PLAYBACK).openFlight("current", 100));
  station.replayed((replay) => replay.greet());
  const list = document.createElement("button");
  document.body.append(list);
  const before = station.replay.asked.length;
  act(() => void fireEvent.keyDown(list, { key: "ArrowUp" }));
  expect(station.replay.asked).toHaveLength(before);
  act(() => void fireEvent.keyDown(list, { key: "ArrowUp", shiftKey: true }));
  expect(station.page.parts.get(PLAYBACK).store.getState().rate).toBe(2);
  list.remove();
});
