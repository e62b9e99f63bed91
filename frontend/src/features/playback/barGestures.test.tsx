import { act, createEvent, fireEvent, screen } from "@testing-library/react";
import { beforeEach, describe, expect, test, vi } from "vitest";
import { FLIGHT } from "../../test/replay";
import { Station } from "../../test/station";
import { PLAYBACK } from "./playbackRequests";
import { TimeTrack } from "./TimeTrack";

let station: Station;
const onMark = vi.fn();

/** The bar is 600 px wide and the flight 600 s long: before any zoom a pixel is a second. */
beforeEach(() => {
  vi.spyOn(HTMLElement.prototype, "clientWidth", "get").mockReturnValue(600);
  vi.spyOn(HTMLElement.prototype, "clientHeight", "get").mockReturnValue(60);
  vi.spyOn(HTMLElement.prototype, "getBoundingClientRect").mockReturnValue(new DOMRect(0, 0, 600, 60));
  onMark.mockClear();
  station = new Station(<TimeTrack onMark={onMark} />);
  station.greet();
});

function playback() {
  return station.page.parts.get(PLAYBACK);
}

function openPast(): void {
  act(() => playback().openFlight(FLIGHT, 100));
  station.replayed((replay) => replay.greet());
}

function bar(): HTMLElement {
  return screen.getByRole("slider", { name: "Momento del vuelo" });
}

type Pointer = Partial<Pick<PointerEvent, "pointerId" | "pointerType" | "button">>;

const MOUSE: Pointer = { pointerId: 1, pointerType: "mouse", button: 0 };
const FINGER: Pointer = { pointerId: 2, pointerType: "touch", button: 0 };
const OTHER_FINGER: Pointer = { pointerId: 3, pointerType: "touch", button: 0 };

const down = (clientX: number, how = MOUSE) => fireEvent.pointerDown(bar(), { ...how, clientX });
const move = (clientX: number, how = MOUSE) => fireEvent.pointerMove(bar(), { ...how, clientX });
const up = (clientX: number, how = MOUSE) => fireEvent.pointerUp(bar(), { ...how, clientX });

function shown_s(): number {
  return playback().store.getState().at_s;
}

/** The moment under a pixel, found by pressing there. */
function momentAt(x: number): number {
  down(x);
  up(x);
  return shown_s();
}

describe("a mouse on the time bar", () => {
  beforeEach(openPast);

  test("shows the moment under it from the press on, for as long as it is held", () => {
    down(200);
    expect(station.replay.asked.at(-1)).toEqual({ type: "seek", at_s: 200 });
    move(250);
    expect(shown_s()).toBe(250);
    up(250);
    move(400);
    expect(shown_s()).toBe(250);
  });

  test("does nothing with its other buttons", () => {
    down(200, { ...MOUSE, button: 2 });
    move(300);
    expect(shown_s()).toBe(100);
  });

  test("never leaves the flight", () => {
    down(-50);
    expect(shown_s()).toBe(0);
    move(900);
    expect(shown_s()).toBe(600);
  });

  test("zooms with its wheel about the moment under it, and moves with Shift", () => {
    fireEvent.wheel(bar(), { clientX: 300, deltaY: -500 });
    expect(momentAt(300)).toBeCloseTo(300);
    const first_s = momentAt(0);
    expect(first_s).toBeGreaterThan(100);
    fireEvent.wheel(bar(), { clientX: 300, deltaY: 60, shiftKey: true });
    const moved_s = momentAt(0);
    expect(moved_s).toBeGreaterThan(first_s);
    fireEvent.wheel(bar(), { clientX: 300, deltaX: -60, deltaY: 0 });
    expect(momentAt(0)).toBeCloseTo(first_s);
    fireEvent.wheel(bar(), { clientX: 300, deltaY: 5000 });
    expect(momentAt(0)).toBe(0);
  });

  test("does not scroll the page by its wheel", () => {
    const turned = createEvent.wheel(bar(), { deltaY: 10 });
    fireEvent(bar(), turned);
    expect(turned.defaultPrevented).toBe(true);
  });
});

describe("a finger on the time bar", () => {
  beforeEach(openPast);

  test("that only touches goes to that moment when it is lifted, though it trembles", () => {
    down(200, FINGER);
    move(202, FINGER);
    expect(shown_s()).toBe(100);
    up(202, FINGER);
    expect(shown_s()).toBe(202);
  });

  test("that moves drags the moment", () => {
    down(200, FINGER);
    move(210, FINGER);
    expect(shown_s()).toBe(210);
  });

  test("that the system takes away changes nothing", () => {
    down(200, FINGER);
    fireEvent.pointerCancel(bar(), { ...FINGER, clientX: 200 });
    expect(shown_s()).toBe(100);
  });

  test("with a second one zooms, and neither drags the moment until both are lifted", () => {
    down(200, FINGER);
    down(400, OTHER_FINGER);
    move(500, OTHER_FINGER);
    move(100, FINGER);
    up(100, FINGER);
    move(450, OTHER_FINGER);
    up(450, OTHER_FINGER);
    expect(shown_s()).toBe(100);
    // Twice as far apart: half of the flight, and what was in the middle is there still.
    const [first_s, middle_s, last_s] = [momentAt(0), momentAt(300), momentAt(600)];
    expect(last_s - first_s).toBeCloseTo(300);
    expect(middle_s).toBeCloseTo(300);
  });
});

test("a zoomed bar follows the moment that leaves it", () => {
  openPast();
  fireEvent.wheel(bar(), { clientX: 100, deltaY: -1000 });
  expect(momentAt(600)).toBeLessThan(400);
  // The replay has gone where it was sent, then plays on to another place.
  station.replayed((replay) => replay.position({ at_s: 590, jumps: 2 }));
  station.replayed((replay) => replay.position({ at_s: 590, jumps: 2 }));
  expect(momentAt(600)).toBeGreaterThan(590);
});

describe("a key on the time bar", () => {
  beforeEach(openPast);

  test("of the time's is done and goes no further", () => {
    const onPage = vi.fn();
    window.addEventListener("keydown", onPage);
    fireEvent.keyDown(bar(), { key: "End" });
    expect(shown_s()).toBe(600);
    fireEvent.keyDown(bar(), { key: "M" });
    expect(onMark).toHaveBeenCalledOnce();
    expect(onPage).not.toHaveBeenCalled();
    window.removeEventListener("keydown", onPage);
  });

  test("that is not of the time's is left to the page", () => {
    expect(fireEvent.keyDown(bar(), { key: "x" })).toBe(true);
  });
});

describe("in the present", () => {
  beforeEach(async () => {
    act(() => playback().facts.refresh());
    for (const asked of station.askedByBar) {
      await asked.answer(
        asked.path.includes("/overview")
          ? { duration_s: 600, signal: "gps.altitude_m", altitude_ft: [0, 10], gaps: [] }
          : { events: [] },
      );
    }
    station.show();
  });

  test("a press into the flight so far opens its past there", () => {
    down(300);
    expect(station.replay.place).toEqual({ flight: "current", at_s: 300 });
  });

  test("a press at its edge is the present", () => {
    down(596);
    expect(station.replays).toEqual([]);
  });

  test("a key that does not go back is left to the page", () => {
    expect(fireEvent.keyDown(bar(), { key: "End" })).toBe(true);
    expect(station.replays).toEqual([]);
  });
});
