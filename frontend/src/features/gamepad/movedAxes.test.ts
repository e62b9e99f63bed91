import { expect, test } from "vitest";
import { aPad } from "../../test/gamepads";
import { MovedAxes } from "./movedAxes";
import { defaultMapping } from "./stickMapping";
import { TOUCH_PAD } from "./touchStick";

const mapping = defaultMapping(aPad());

function awaitedAfter(...readings: ReadonlyArray<readonly number[]>) {
  const moved = new MovedAxes();
  for (const axes of readings) {
    moved.follow([aPad({ axes })]);
  }
  return moved.awaited(aPad(), mapping);
}

test("an axis is awaited until it reads something else than at the connection, also where that was not 0", () => {
  expect(awaitedAfter([0, -1, 0, 0])).toEqual(["elevator", "aileron", "rudder", "throttle"]);
  expect(awaitedAfter([0, -1, 0, 0], [0, -1, 0, 0.2])).toEqual(["aileron", "rudder", "throttle"]);
  expect(awaitedAfter([0, -1, 0, 0], [0.1, 0, 0.1, 0.2], [0, -1, 0, 0])).toEqual([]);
});

test("a trembling axis has not moved", () => {
  expect(awaitedAfter([0, 0, 0, 0], [0.04, -0.04, 0.04, -0.04])).toHaveLength(4);
});

test("a button that is the throttle is not awaited: it reads 0 because nobody presses it", () => {
  const moved = new MovedAxes();
  const trigger = { ...mapping, throttle: { ...mapping.throttle, input: "b7" } } as const;
  moved.follow([aPad()]);
  expect(moved.awaited(aPad(), trigger)).toEqual(["elevator", "aileron", "rudder"]);
});

test("two gamepads of one model are told apart", () => {
  const moved = new MovedAxes();
  moved.follow([aPad(), aPad({ index: 1 })]);
  moved.follow([aPad({ axes: [1, 1, 1, 1] }), aPad({ index: 1 })]);
  expect(moved.awaited(aPad(), mapping)).toEqual([]);
  expect(moved.awaited(aPad({ index: 1 }), mapping)).toHaveLength(4);
});

test("the stick on the screen is never awaited: it knows where its finger is", () => {
  expect(new MovedAxes().awaited({ ...aPad(TOUCH_PAD), mapping }, mapping)).toEqual([]);
});
