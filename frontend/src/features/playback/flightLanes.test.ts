import { expect, test } from "vitest";
import { aFlightEvent } from "../../test/flights";
import { eventAfter, eventBefore, laneOf } from "./flightLanes";

function alarm(at_s: number, lasted_s: number | null) {
  const t_s = 1_700_000_000 + at_s;
  return aFlightEvent({
    kind: "alarm",
    name: "hil_lost",
    at_s,
    t_s,
    until_s: lasted_s === null ? null : t_s + lasted_s,
  });
}

test("an alarm of a blink is nothing to go to, one that lasted or lasts is", () => {
  const events = [alarm(1, 0.1), alarm(2, 4), alarm(3, 0.1), alarm(4, null)];
  expect(eventAfter(events, 0)?.at_s).toBe(2);
  expect(eventAfter(events, 2)?.at_s).toBe(4);
  expect(eventBefore(events, 4)?.at_s).toBe(2);
});

test("who moves the surfaces, the stick and limits have their lanes, and are gone to", () => {
  const kinds = ["mode", "stick", "limits", "restart", "jump"] as const;
  expect(kinds.map((kind) => laneOf({ kind }))).toEqual(["mode", "mode", "command", "alarm", "mode"]);
  const switched = aFlightEvent({ kind: "mode", name: "assisted", at_s: 70.65 });
  expect(eventAfter([alarm(82.91, 2), switched], 63.65)).toBe(switched);
});
