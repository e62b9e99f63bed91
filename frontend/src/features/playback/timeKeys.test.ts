import { describe, expect, test } from "vitest";
import { createStore } from "zustand/vanilla";
import type { Playback } from "./playbackRequests";
import { type PlaybackState, PRESENT } from "./playbackState";
import { enterPast, runInPast, timeAction } from "./timeKeys";

const NONE = { shiftKey: false, ctrlKey: false, altKey: false, metaKey: false };

function pressed(key: string, held: Partial<typeof NONE> = {}) {
  return timeAction({ key, ...NONE, ...held });
}

/** A playback of a flight, at 100 s of 600, that keeps what was asked of it. */
function aPlayback(parts: Partial<PlaybackState> = {}) {
  const asked: unknown[][] = [];
  const ask =
    (what: string) =>
    (...how: unknown[]) => {
      asked.push([what, ...how]);
    };
  const store = createStore(() => ({ ...PRESENT, flight: "f", at_s: 100, edge_s: 600, ...parts }));
  const names = ["now", "play", "pause", "step", "seek", "jump", "setRate", "openFlight"] as const;
  const playback = { store, ...Object.fromEntries(names.map((name) => [name, ask(name)])) };
  return { playback: playback as unknown as Playback, asked };
}

describe("a key", () => {
  test("with Alt or the Windows key belongs to the system", () => {
    expect(pressed("ArrowLeft", { altKey: true })).toBeNull();
    expect(pressed("Home", { metaKey: true })).toBeNull();
  });

  test("with Ctrl belongs to the browser, save for the arrows", () => {
    expect(pressed("Home", { ctrlKey: true })).toBeNull();
    expect(pressed("M", { ctrlKey: true })).toBeNull();
    expect(pressed("ArrowRight", { ctrlKey: true })).toEqual({ do: "seconds", by_s: 10 });
  });

  test("that is none of the time's does nothing", () => {
    expect(pressed("x")).toBeNull();
    // A small letter is a shortcut of the page; the mark has the capital one.
    expect(pressed("m")).toBeNull();
  });
});

describe("in the past", () => {
  test.each([
    ["Escape", {}, [["now"]]],
    ["ArrowRight", {}, [["step", 1]]],
    ["ArrowLeft", {}, [["step", -1]]],
    ["ArrowLeft", { shiftKey: true }, [["seek", 99]]],
    ["ArrowRight", { ctrlKey: true }, [["seek", 110]]],
    ["PageUp", {}, [["jump", 1]]],
    ["PageDown", {}, [["jump", -1]]],
    ["ArrowUp", {}, [["setRate", 2]]],
    ["ArrowDown", {}, [["setRate", 0.5]]],
    ["Home", {}, [["seek", 0]]],
    ["End", {}, [["seek", 600]]],
  ] as const)("%s %o goes where it says", (key, held, expected) => {
    const { playback, asked } = aPlayback();
    const action = pressed(key, held);
    expect(action !== null && runInPast(playback, action)).toBe(true);
    expect(asked).toEqual(expected);
  });

  test("the space bar plays what stands and stops what plays", () => {
    const [standing, playing] = [aPlayback({ state: "paused" }), aPlayback({ state: "playing" })];
    runInPast(standing.playback, { do: "toggle" });
    runInPast(playing.playback, { do: "toggle" });
    expect([standing.asked, playing.asked]).toEqual([[["play"]], [["pause"]]]);
  });

  test("at the fastest and the slowest speed the key changes nothing", () => {
    const [fastest, slowest] = [aPlayback({ rate: 100 }), aPlayback({ rate: 0.1 })];
    runInPast(fastest.playback, { do: "rate", direction: 1 });
    runInPast(slowest.playback, { do: "rate", direction: -1 });
    expect([fastest.asked, slowest.asked]).toEqual([[["setRate", 100]], [["setRate", 0.1]]]);
  });

  test("a mark is left to who asks for its words", () => {
    const { playback, asked } = aPlayback();
    expect(runInPast(playback, { do: "mark" })).toBe(false);
    expect(asked).toEqual([]);
  });
});

describe("in the present", () => {
  test.each([
    ["ArrowLeft", {}, 599],
    ["ArrowLeft", { shiftKey: true }, 599],
    ["ArrowLeft", { ctrlKey: true }, 590],
    ["Home", {}, 0],
  ] as const)("%s %o enters the past of the flight under way", (key, held, at_s) => {
    const { playback, asked } = aPlayback({ flight: null });
    const action = pressed(key, held);
    expect(action !== null && enterPast(playback, action, 600)).toBe(true);
    expect(asked).toEqual([["openFlight", "current", at_s]]);
  });

  test.each(["ArrowRight", "End", " ", "PageDown", "ArrowUp", "Escape"])(
    "%s stays in the present, and is left to the page",
    (key) => {
      const { playback, asked } = aPlayback({ flight: null });
      const action = pressed(key);
      expect(action !== null && enterPast(playback, action, 600)).toBe(false);
      expect(asked).toEqual([]);
    },
  );
});
