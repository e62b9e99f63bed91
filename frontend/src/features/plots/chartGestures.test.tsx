import { fireEvent } from "@testing-library/react";
import { beforeEach, describe, expect, test, vi } from "vitest";
import { ManualTimers } from "../../test/wire";
import { ChartGestures } from "./chartGestures";

const listener = {
  onZoomTo: vi.fn(),
  onZoom: vi.fn(),
  onPan: vi.fn(),
  onAll: vi.fn(),
  onMoment: vi.fn(),
  onHover: vi.fn(),
};
let over: HTMLElement;
let timers: ManualTimers;
let gestures: ChartGestures;

/** A chart of 500 px that shows 50 s from 0 on: ten pixels are a second. */
beforeEach(() => {
  vi.clearAllMocks();
  over = document.createElement("div");
  document.body.append(over);
  vi.spyOn(over, "getBoundingClientRect").mockReturnValue(new DOMRect(100, 0, 500, 200));
  timers = new ManualTimers();
  gestures = new ChartGestures(over, { momentAt: (x) => x / 10, span_s: () => 50, listener, timers });
  return () => {
    gestures.end();
    over.remove();
  };
});

const [FIRST, SECOND] = [
  { pointerId: 1, pointerType: "touch", button: 0 },
  { pointerId: 2, pointerType: "touch", button: 0 },
];
const MOUSE = { pointerId: 3, pointerType: "mouse", button: 0 };

describe("the wheel on a plot", () => {
  test("zooms about the moment under the pointer, closer when it is turned up", () => {
    fireEvent.wheel(over, { clientX: 300, deltaY: -100 });
    const [about_s, factor] = listener.onZoom.mock.calls[0] ?? [];
    expect(about_s).toBe(20);
    expect(factor).toBeLessThan(1);
    fireEvent.wheel(over, { clientX: 300, deltaY: 100 });
    expect(listener.onZoom.mock.calls[1]?.[1]).toBeCloseTo(1 / factor);
  });

  test("moves in time with Shift, and when it is turned sideways", () => {
    fireEvent.wheel(over, { clientX: 300, deltaY: 100, shiftKey: true });
    fireEvent.wheel(over, { clientX: 300, deltaX: -50, deltaY: 10 });
    expect(listener.onPan.mock.calls).toEqual([[10], [-5]]);
    expect(listener.onZoom).not.toHaveBeenCalled();
  });
});

describe("fingers on a plot", () => {
  test("one moves the stretch, and sets no moment when it is lifted", () => {
    fireEvent.pointerDown(over, { ...FIRST, clientX: 300 });
    fireEvent.pointerMove(over, { ...FIRST, clientX: 302 });
    expect(listener.onPan).not.toHaveBeenCalled();
    fireEvent.pointerMove(over, { ...FIRST, clientX: 250 });
    fireEvent.pointerUp(over, { ...FIRST, clientX: 250 });
    timers.pass(1000);
    expect(listener.onPan.mock.calls).toEqual([[5]]);
    expect(listener.onMoment).not.toHaveBeenCalled();
  });

  test("two zoom about what is between them", () => {
    fireEvent.pointerDown(over, { ...FIRST, clientX: 200 });
    fireEvent.pointerDown(over, { ...SECOND, clientX: 300 });
    fireEvent.pointerMove(over, { ...SECOND, clientX: 400 });
    expect(listener.onZoom.mock.calls).toEqual([[20, 0.5]]);
    fireEvent.pointerUp(over, { ...SECOND, clientX: 400 });
    fireEvent.pointerUp(over, { ...FIRST, clientX: 200 });
    timers.pass(1000);
    expect(listener.onMoment).not.toHaveBeenCalled();
  });

  test("a short touch sets the moment, but none that the system takes away", () => {
    fireEvent.pointerDown(over, { ...FIRST, clientX: 300 });
    fireEvent.pointerCancel(over, { ...FIRST, clientX: 300 });
    timers.pass(1000);
    expect(listener.onMoment).not.toHaveBeenCalled();
    fireEvent.pointerDown(over, { ...FIRST, clientX: 300 });
    fireEvent.pointerUp(over, { ...FIRST, clientX: 301 });
    timers.pass(1000);
    expect(listener.onMoment.mock.calls).toEqual([[20.1]]);
  });
});

describe("the mouse on a plot", () => {
  test("sets the moment by a click, never before the flight's start", () => {
    fireEvent.pointerDown(over, { ...MOUSE, clientX: 90 });
    fireEvent.pointerUp(over, { ...MOUSE, clientX: 90 });
    timers.pass(1000);
    expect(listener.onMoment.mock.calls).toEqual([[0]]);
  });

  test("sets none by a drag, which is the plot's own, nor by another button or by passing over it", () => {
    fireEvent.pointerMove(over, { ...MOUSE, clientX: 200 });
    fireEvent.pointerDown(over, { ...MOUSE, clientX: 200 });
    fireEvent.pointerMove(over, { ...MOUSE, clientX: 300 });
    fireEvent.pointerUp(over, { ...MOUSE, clientX: 300 });
    fireEvent.pointerDown(over, { ...MOUSE, button: 2, clientX: 200 });
    fireEvent.pointerUp(over, { ...MOUSE, button: 2, clientX: 200 });
    timers.pass(1000);
    expect(listener.onMoment).not.toHaveBeenCalled();
    expect(listener.onPan).not.toHaveBeenCalled();
  });

  test("sets none any more after the plot is gone", () => {
    fireEvent.pointerDown(over, { ...MOUSE, clientX: 200 });
    fireEvent.pointerUp(over, { ...MOUSE, clientX: 200 });
    gestures.end();
    timers.pass(1000);
    fireEvent.wheel(over, { clientX: 300, deltaY: 100 });
    expect(listener.onMoment).not.toHaveBeenCalled();
    expect(listener.onZoom).not.toHaveBeenCalled();
  });
});
