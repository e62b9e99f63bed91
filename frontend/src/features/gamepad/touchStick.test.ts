import { describe, expect, test, vi } from "vitest";
import { stickPosition } from "./stickMapping";
import { createTouchStick, TOUCH_PAD, TRAVEL_PX, withTouchStick } from "./touchStick";

const middle = { x: 500, y: 300 };

/** What would be flown: null while no finger holds the stick. */
function flown({ reader }: ReturnType<typeof createTouchStick>) {
  const [pad] = reader.read();
  return pad?.mapping === undefined ? null : stickPosition(pad, pad.mapping);
}

describe("a stick on the screen", () => {
  test("is there only while a finger holds it, and its middle is where the finger came down", () => {
    const touch = createTouchStick();
    expect(flown(touch)).toBeNull();
    touch.stick.hold(middle, 0.4);
    expect(flown(touch)).toEqual({ elevator: 0, aileron: 0, rudder: 0, throttle: 0.4 });
    touch.stick.letGo();
    expect(flown(touch)).toBeNull();
  });

  test("pulled down is nose up, to the right is right wing down, and beyond its travel it stands at the stop", () => {
    const touch = createTouchStick();
    touch.stick.hold(middle, 0);
    touch.stick.move({ x: middle.x + TRAVEL_PX, y: middle.y + 10 * TRAVEL_PX });
    expect(flown(touch)).toMatchObject({ elevator: 1, aileron: 1 });
    touch.stick.move({ x: middle.x - TRAVEL_PX, y: middle.y - TRAVEL_PX });
    expect(flown(touch)).toMatchObject({ elevator: -1, aileron: -1 });
  });

  test("has throttle and rudder at a second finger; when it leaves, the throttle stays and the rudder springs back", () => {
    const touch = createTouchStick();
    touch.stick.hold(middle, 0.5);
    touch.stick.holdLever({ x: 100, y: 300 });
    touch.stick.moveLever({ x: 100 + TRAVEL_PX, y: 300 - 1000 });
    expect(flown(touch)).toMatchObject({ rudder: 1, throttle: 1 });
    touch.stick.leaveLever();
    expect(flown(touch)).toMatchObject({ rudder: 0, throttle: 1 });
  });

  test("does not hear the second finger alone, nor one that stays when the first has left", () => {
    const touch = createTouchStick();
    touch.stick.holdLever({ x: 100, y: 300 });
    touch.stick.moveLever({ x: 100, y: 0 });
    expect(flown(touch)).toBeNull();
    touch.stick.hold(middle, 0);
    touch.stick.holdLever({ x: 100, y: 300 });
    touch.stick.letGo();
    touch.stick.moveLever({ x: 100, y: 0 });
    touch.stick.hold(middle, 0);
    expect(flown(touch)).toMatchObject({ throttle: 0 });
  });

  test("says so when a finger takes it and when it is let go, as a gamepad that is plugged in and out", () => {
    const touch = createTouchStick();
    const run = vi.fn();
    const browser = { read: () => [], isInSight: () => true, onChange: () => () => undefined };
    const both = withTouchStick(browser, touch.reader);
    const cancel = both.onChange(run);
    touch.stick.hold(middle, 0);
    expect(both.read()).toMatchObject([TOUCH_PAD]);
    touch.stick.move({ x: 510, y: 300 });
    touch.stick.letGo();
    touch.stick.letGo();
    expect(run).toHaveBeenCalledTimes(2);
    cancel();
    touch.stick.hold(middle, 0);
    expect(run).toHaveBeenCalledTimes(2);
  });
});
