import { expect, test } from "vitest";
import { ManualTimers } from "../test/wire";
import {
  announce,
  createMessages,
  failureMessage,
  type MessageStore,
  MOST_KEPT,
  READABLE_MS,
  say,
} from "./messages";
import type { BrowserStorage } from "./settings";

test("the last message is the one shown, and the same words said again are a new message", () => {
  const store = createMessages();
  const message = { level: "info", key: "said.confirmed", params: { what: "ahrs_on" } } as const;
  say(store, message, 1000);
  say(store, message, 2000);
  expect(store.getState().last).toEqual({ ...message, number: 2, said_ms: 2000 });
});

const SAID = { level: "warning", key: "said.malformed", params: { count: 3 } } as const;
const CONFIRMED = { level: "info", key: "said.confirmed", params: {} } as const;
const CONTROL = { level: "info", key: "said.control", params: {} } as const;
const NOT_DONE = { level: "warning", key: "said.notDone", params: { reason: "no link" } } as const;

const lastSaid = (store: MessageStore): string | undefined => store.getState().last?.key;

test("an information that nobody asked for waits until a refusal could be read", () => {
  const store = createMessages();
  const timers = new ManualTimers();
  say(store, NOT_DONE, 1000);
  announce(store, timers, CONTROL, 1001);
  timers.pass(READABLE_MS - 2);
  expect(lastSaid(store)).toBe("said.notDone");
  expect(store.getState().kept.map(({ key }) => key)).toEqual(["said.notDone", "said.control"]);
  timers.pass(1);
  expect(lastSaid(store)).toBe("said.control");
});

test("the answer to the next press takes the place of a refusal at once, and of what waited behind it", () => {
  const store = createMessages();
  const timers = new ManualTimers();
  say(store, NOT_DONE, 1000);
  announce(store, timers, SAID, 1001);
  say(store, NOT_DONE, 1002);
  announce(store, timers, CONTROL, 1003);
  say(store, CONFIRMED, 1004);
  timers.pass(READABLE_MS);
  expect(store.getState().last).toEqual({ ...CONFIRMED, number: 5, said_ms: 1004 });
});

test("a second refusal has its own time to be read", () => {
  const store = createMessages();
  const timers = new ManualTimers();
  say(store, NOT_DONE, 0);
  announce(store, timers, CONTROL, 0);
  timers.pass(READABLE_MS - 1);
  say(store, NOT_DONE, READABLE_MS - 1);
  announce(store, timers, CONTROL, READABLE_MS - 1);
  timers.pass(READABLE_MS - 1);
  expect(lastSaid(store)).toBe("said.notDone");
});

test("a warning waits for nothing, and what ends it does not either", () => {
  const store = createMessages();
  const timers = new ManualTimers();
  say(store, NOT_DONE, 1000);
  announce(store, timers, SAID, 1001);
  expect(lastSaid(store)).toBe("said.malformed");
  announce(store, timers, CONTROL, 1002);
  expect(lastSaid(store)).toBe("said.control");
});

test("a clock that is set back holds nothing", () => {
  const store = createMessages();
  say(store, NOT_DONE, 9000);
  announce(store, new ManualTimers(), CONTROL, 1000);
  expect(lastSaid(store)).toBe("said.control");
});

test("a refusal is an error of its code, with the values that a sentence can say and the gateway's own text", () => {
  const params = { what: "ahrs_on", seconds: 2, isLost: true, link: null, rows: [3] };
  expect(failureMessage({ code: "timed_out", detail: "Nothing came.", params })).toEqual({
    level: "error",
    key: "problem.timed_out",
    params: { what: "ahrs_on", seconds: 2 },
    fallback: "Nothing came.",
  });
});

test("nothing is said before the first message", () => {
  expect(createMessages().getState()).toMatchObject({ last: null, kept: [] });
});

function memory(): BrowserStorage & { readonly texts: Map<string, string> } {
  const texts = new Map<string, string>();
  return {
    texts,
    getItem: (key) => texts.get(key) ?? null,
    setItem: (key, value) => void texts.set(key, value),
  };
}

test("what was said is kept over a reload, but nothing of it looks like the newest message", () => {
  const storage = memory();
  say(createMessages(storage), SAID, 1000);
  const reloaded = createMessages(storage);
  expect(reloaded.getState()).toMatchObject({ last: null, kept: [{ ...SAID, number: 1, said_ms: 1000 }] });
  say(reloaded, SAID, 2000);
  expect(reloaded.getState().last?.number).toBe(2);
});

test("the oldest messages make room", () => {
  const storage = memory();
  const store = createMessages(storage);
  for (let at_ms = 0; at_ms < MOST_KEPT + 5; at_ms += 1) {
    say(store, SAID, at_ms);
  }
  const { kept } = createMessages(storage).getState();
  expect([kept.length, kept[0]?.said_ms]).toEqual([MOST_KEPT, 5]);
});

test.each([
  "nonsense",
  "{}",
  '[{"level":"loud"}, 3, null, {"level":"info","key":"a","params":{"x":[]},"number":1,"said_ms":1}]',
])("stored messages that are none are left out: %s", (stored) => {
  const storage = memory();
  say(createMessages(storage), SAID, 1);
  storage.texts.set([...storage.texts.keys()][0] ?? "", stored);
  expect(createMessages(storage).getState().kept).toEqual([]);
});

test("a full or forbidden storage keeps nobody from speaking", () => {
  const forbidden: BrowserStorage = {
    getItem: () => {
      throw new Error("forbidden");
    },
    setItem: () => {
      throw new Error("full");
    },
  };
  const store = createMessages(forbidden);
  say(store, SAID, 1);
  expect(store.getState().kept).toHaveLength(1);
});
