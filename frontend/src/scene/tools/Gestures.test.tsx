import { afterEach, beforeEach, describe, expect, test, vi } from "vitest";
import { Gestures, LONG_PRESS_MS } from "./Gestures";

beforeEach(() => {
  vi.useFakeTimers();
});
afterEach(() => {
  vi.useRealTimers();
  document.body.replaceChildren();
});

function canvas() {
  const element = document.createElement("canvas");
  document.body.append(element);
  const hands = { tap: vi.fn(), double: vi.fn(), menu: vi.fn() };
  const gestures = new Gestures(element, hands);
  const send = (
    type: string,
    at: readonly [number, number],
    { id = 1, button = 0, pointerType = "mouse", time_ms = 0, isPrimary = true } = {},
  ): void => {
    const event = new PointerEvent(type, {
      pointerId: id,
      button,
      pointerType,
      isPrimary,
      bubbles: true,
      cancelable: true,
    });
    Object.defineProperties(event, {
      offsetX: { value: at[0] },
      offsetY: { value: at[1] },
      timeStamp: { value: time_ms },
    });
    element.dispatchEvent(event);
  };
  return { element, hands, gestures, send };
}

const TOUCH = { pointerType: "touch" };

describe("a finger on the map", () => {
  test("that rests half a second asks for the menu where it is, and is no tap afterwards", () => {
    const { hands, send } = canvas();
    send("pointerdown", [100, 80], TOUCH);
    send("pointermove", [106, 84], TOUCH);
    vi.advanceTimersByTime(LONG_PRESS_MS - 1);
    expect(hands.menu).not.toHaveBeenCalled();
    vi.advanceTimersByTime(1);
    expect(hands.menu.mock.calls).toEqual([[{ x: 100, y: 80 }, true]]);
    send("pointerup", [106, 84], TOUCH);
    expect(hands.tap).not.toHaveBeenCalled();
  });

  test.each([
    ["moves away", [130, 80]],
    ["moves away slowly to the side", [100, 93]],
  ] as const)("that %s asks for nothing", (_, to) => {
    const { hands, send } = canvas();
    send("pointerdown", [100, 80], TOUCH);
    send("pointermove", to, TOUCH);
    vi.advanceTimersByTime(2 * LONG_PRESS_MS);
    send("pointerup", to, TOUCH);
    expect(hands.menu).not.toHaveBeenCalled();
    expect(hands.tap).not.toHaveBeenCalled();
  });

  test("beside a second one asks for nothing: two fingers spread the map", () => {
    const { hands, send } = canvas();
    send("pointerdown", [100, 80], TOUCH);
    send("pointerdown", [180, 80], { ...TOUCH, id: 2, isPrimary: false });
    vi.advanceTimersByTime(2 * LONG_PRESS_MS);
    send("pointerup", [180, 80], { ...TOUCH, id: 2, isPrimary: false });
    send("pointerup", [100, 80], TOUCH);
    expect(hands.menu).not.toHaveBeenCalled();
    expect(hands.tap).not.toHaveBeenCalled();
  });
});

describe("a mouse on the map", () => {
  test("taps, and a second tap soon and near is a double one", () => {
    const { hands, send } = canvas();
    for (const time_ms of [1000, 1200]) {
      send("pointerdown", [50, 50], { time_ms });
      send("pointerup", [51, 50], { time_ms: time_ms + 40 });
    }
    expect(hands.tap).toHaveBeenCalledOnce();
    expect(hands.double.mock.calls).toEqual([[{ x: 50, y: 50 }]]);
  });

  test("that taps twice slowly, or at two places, taps twice", () => {
    const { hands, send } = canvas();
    const taps = [
      [50, 1000],
      [50, 3000],
      [90, 3100],
    ] as const;
    for (const [x, time_ms] of taps) {
      send("pointerdown", [x, 50], { time_ms });
      send("pointerup", [x, 50], { time_ms });
    }
    expect(hands.tap).toHaveBeenCalledTimes(3);
    expect(hands.double).not.toHaveBeenCalled();
  });

  test("asks for the menu with the other button, but not when that turns the map", () => {
    const { element, hands, send } = canvas();
    send("pointerdown", [50, 50], { button: 2 });
    send("pointermove", [90, 50], { button: 2 });
    send("pointerup", [90, 50], { button: 2 });
    expect(hands.menu).not.toHaveBeenCalled();
    send("pointerdown", [50, 50], { button: 2 });
    send("pointerup", [50, 50], { button: 2 });
    expect(hands.menu).toHaveBeenCalledOnce();
    expect(hands.tap).not.toHaveBeenCalled();
    const own = new MouseEvent("contextmenu", { bubbles: true, cancelable: true });
    element.dispatchEvent(own);
    expect(own.defaultPrevented).toBe(true);
  });

  test("that rests is no long press, and what is gone hears nothing", () => {
    const { hands, gestures, send } = canvas();
    send("pointerdown", [50, 50]);
    vi.advanceTimersByTime(2 * LONG_PRESS_MS);
    expect(hands.menu).not.toHaveBeenCalled();
    gestures.dispose();
    send("pointerup", [50, 50]);
    expect(hands.tap).not.toHaveBeenCalled();
  });
});
