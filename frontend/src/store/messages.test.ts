import { expect, test } from "vitest";
import { ManualTimers } from "../test/wire";
import { createMessages, failureMessage, MOST_KEPT, READABLE_MS } from "./messages";
import type { BrowserStorage } from "./settings";

const START_MS = 1_700_000_000_000;

/** The messages of a page, whose time the test lets pass. */
function messagesOf(storage?: BrowserStorage) {
  const timers = new ManualTimers();
  const store = createMessages({ timers, wall_ms: () => START_MS + timers.now_ms() }, storage);
  return { store, timers, last: () => store.getState().last?.key };
}

const SAID = { level: "warning", key: "said.malformed", params: { count: 3 } } as const;
const CONFIRMED = { level: "info", key: "said.confirmed", params: {} } as const;
const CONTROL = { level: "info", key: "said.control", params: {} } as const;
const LINK = { level: "info", key: "said.link", params: {} } as const;
const NOT_DONE = { level: "warning", key: "said.notDone", params: { reason: "no link" } } as const;

test("the last message is the one shown, and the same words said again are a new message", () => {
  const { store, timers } = messagesOf();
  store.say(CONFIRMED);
  timers.pass(1000);
  store.say(CONFIRMED);
  expect(store.getState().last).toEqual({ ...CONFIRMED, number: 2, said_ms: START_MS + 1000 });
});

test.each([NOT_DONE, CONFIRMED])(
  "an information that nobody asked for waits until an answer could be read: $level",
  (answer) => {
    const { store, timers, last } = messagesOf();
    store.say(answer);
    timers.pass(1);
    store.announce(CONTROL);
    store.announce(LINK);
    timers.pass(READABLE_MS - 2);
    expect(last()).toBe(answer.key);
    expect(store.getState().kept.map(({ key }) => key)).toEqual([answer.key, "said.control", "said.link"]);
    timers.pass(1);
    expect(last()).toBe("said.link");
    store.announce(CONTROL);
    expect(last()).toBe("said.control");
  },
);

test("the answer to the next press takes the place of the one before at once, and of what waited behind it", () => {
  const { store, timers, last } = messagesOf();
  store.say(NOT_DONE);
  store.announce(CONTROL);
  store.say(CONFIRMED);
  expect(last()).toBe("said.confirmed");
  timers.pass(READABLE_MS);
  expect(last()).toBe("said.confirmed");
});

test("a second answer has its own time to be read", () => {
  const { store, timers, last } = messagesOf();
  store.say(NOT_DONE);
  timers.pass(READABLE_MS - 1);
  store.say(NOT_DONE);
  store.announce(CONTROL);
  timers.pass(READABLE_MS - 1);
  expect(last()).toBe("said.notDone");
});

test("a warning waits for nothing, and what ends it does not either", () => {
  const { store, timers, last } = messagesOf();
  store.say(NOT_DONE);
  store.announce(CONTROL);
  store.announce(SAID);
  expect(last()).toBe("said.malformed");
  timers.pass(READABLE_MS);
  expect(last()).toBe("said.malformed");
  store.say(NOT_DONE);
  store.announce(SAID);
  store.announce(LINK);
  expect(last()).toBe("said.link");
});

test("a press that does nothing is answered, and many in a second are answered once", () => {
  const { store, timers } = messagesOf();
  const count = (): number => store.getState().kept.length;
  store.refuse("no link");
  timers.pass(900);
  store.refuse("no link");
  expect([count(), store.getState().last]).toEqual([1, { ...NOT_DONE, number: 1, said_ms: START_MS }]);
  store.refuse("no control");
  expect(count()).toBe(2);
  timers.pass(1000);
  store.refuse("no control");
  expect(count()).toBe(3);
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
  expect(messagesOf().store.getState()).toEqual({ last: null, kept: [] });
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
  messagesOf(storage).store.say(SAID);
  const { store: reloaded } = messagesOf(storage);
  expect(reloaded.getState()).toEqual({ last: null, kept: [{ ...SAID, number: 1, said_ms: START_MS }] });
  reloaded.say(SAID);
  expect(reloaded.getState().last?.number).toBe(2);
});

test("the oldest messages make room", () => {
  const storage = memory();
  const { store } = messagesOf(storage);
  for (let number = 1; number <= MOST_KEPT + 5; number += 1) {
    store.announce(SAID);
  }
  const { kept } = messagesOf(storage).store.getState();
  expect([kept.length, kept[0]?.number]).toEqual([MOST_KEPT, 6]);
});

test.each([
  "nonsense",
  "{}",
  '[{"level":"loud"}, 3, null, {"level":"info","key":"a","params":{"x":[]},"number":1,"said_ms":1}]',
])("stored messages that are none are left out: %s", (stored) => {
  const storage = memory();
  messagesOf(storage).store.say(SAID);
  storage.texts.set([...storage.texts.keys()][0] ?? "", stored);
  expect(messagesOf(storage).store.getState().kept).toEqual([]);
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
  const { store } = messagesOf(forbidden);
  store.say(SAID);
  expect(store.getState().kept).toHaveLength(1);
});
