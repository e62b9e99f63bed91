import { afterEach, describe, expect, test, vi } from "vitest";
import { FlatPointer } from "./FlatPointer";

/** A canvas with something to pull at 100, 100, and what the map is told. */
function canvasWithGrip() {
  const canvas = document.createElement("canvas");
  canvas.setPointerCapture = () => undefined;
  document.body.append(canvas);
  const drag = { move: vi.fn(), drop: vi.fn(), cancel: vi.fn() };
  const click = vi.fn();
  const hands = {
    find: ({ x, y }: { x: number; y: number }) =>
      x === 100 && y === 100 ? { cursor: "grab", click, drag: () => drag } : null,
    cursor: () => "",
    tap: vi.fn(),
    double: vi.fn(),
    menu: vi.fn(),
    pan: vi.fn(),
    zoom: vi.fn(),
    hover: vi.fn(),
  };
  new FlatPointer(canvas, hands);
  const send = (type: string, x: number, y: number): void => {
    const event = new PointerEvent(type, { pointerId: 1, button: 0, bubbles: true });
    Object.defineProperties(event, { offsetX: { value: x }, offsetY: { value: y } });
    canvas.dispatchEvent(event);
  };
  return { hands, drag, click, send };
}

afterEach(() => document.body.replaceChildren());

describe("a hand on the flat map", () => {
  test("pulls what it took hold of, and puts it down where it is lifted", () => {
    const { hands, drag, click, send } = canvasWithGrip();
    send("pointerdown", 100, 100);
    send("pointermove", 120, 130);
    send("pointerup", 120, 130);
    expect(drag.move).toHaveBeenLastCalledWith({ x: 120, y: 130 }, false);
    expect(drag.drop).toHaveBeenCalledOnce();
    expect(click).not.toHaveBeenCalled();
    expect(hands.pan).not.toHaveBeenCalled();
  });

  test("moves and presses nothing after Escape until it is lifted", () => {
    const { hands, drag, click, send } = canvasWithGrip();
    send("pointerdown", 100, 100);
    send("pointermove", 120, 130);
    window.dispatchEvent(new KeyboardEvent("keydown", { key: "Escape" }));
    send("pointermove", 160, 170);
    send("pointerup", 160, 170);
    expect(drag.cancel).toHaveBeenCalledOnce();
    expect(drag.drop).not.toHaveBeenCalled();
    expect(hands.pan).not.toHaveBeenCalled();
    expect(click).not.toHaveBeenCalled();
    send("pointerdown", 300, 300);
    send("pointermove", 320, 310);
    expect(hands.pan).toHaveBeenLastCalledWith(-20, -10);
  });
});
