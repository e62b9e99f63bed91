import { beforeEach, expect, test } from "vitest";
import type { Gateway } from "../../requests/asking";
import { ManualTimers } from "../../test/wire";
import { createFlightFacts } from "./flightFacts";
import { createPlaybackStore, type PlaybackStore } from "./playbackState";

const FLIGHT = "20260131T120000Z";

let timers: ManualTimers;
let playback: PlaybackStore;
let asked: string[];
/** How far the flight goes when it is read. */
let edge_s: number;

beforeEach(() => {
  timers = new ManualTimers();
  playback = createPlaybackStore();
  asked = [];
  edge_s = 600;
  const rest = {
    ask: (_: string, path: string) => {
      asked.push(path);
      const overview = { duration_s: edge_s, signal: "gps.altitude_m", altitude_ft: [], gaps: [] };
      return Promise.resolve({ ok: true, value: path.includes("overview") ? overview : { events: [] } });
    },
  } as unknown as Gateway;
  createFlightFacts({ rest, timers, playback, isRecording: () => true }).watch();
});

/** Time passes, and what is asked meanwhile is answered. */
async function minute(): Promise<void> {
  for (let second = 0; second < 60; second += 1) {
    timers.pass(1000);
    await new Promise((done) => setTimeout(done, 0));
  }
}

test("the flight that is recorded is read again and again, for it grows", async () => {
  await minute();
  expect(asked.filter((path) => path.includes("current/overview")).length).toBeGreaterThan(4);
});

test("a finished flight is read once", async () => {
  playback.setState({ flight: FLIGHT, edge_s: 600, duration_s: 600 });
  await minute();
  expect(asked.filter((path) => path.includes(`${FLIGHT}/events`))).toHaveLength(1);
});

test("one whose replay goes further than what was read is read again", async () => {
  playback.setState({ flight: FLIGHT, edge_s: 600, duration_s: 600 });
  await minute();
  edge_s = 660;
  playback.setState({ edge_s });
  await minute();
  expect(asked.filter((path) => path.includes(`${FLIGHT}/events`))).toHaveLength(2);
});
