import { expect, test } from "vitest";
import { begin, createCommands, finish, shown } from "./commands";

const KEY = "autopilot";

test("a command is pending until its outcome is known, however long that takes", () => {
  const store = createCommands();
  begin(store, KEY, "on");
  expect(shown(store.getState(), KEY, 1e9)).toMatchObject({ state: "pending", asked: "on" });
});

test("a confirmation is shown for a while and then makes room", () => {
  const store = createCommands();
  finish(store, KEY, begin(store, KEY, "on"), { state: "confirmed", message: null }, 1000);
  expect(shown(store.getState(), KEY, 2000)?.state).toBe("confirmed");
  expect(shown(store.getState(), KEY, 5000)).toBeNull();
});

test("a failure keeps its reason and stays longer than a success", () => {
  const store = createCommands();
  const message = { level: "error", key: "problem.timed_out", params: {} } as const;
  finish(store, KEY, begin(store, KEY, "on"), { state: "timed_out", message }, 1000);
  expect(shown(store.getState(), KEY, 5000)).toMatchObject({ state: "timed_out", message });
  expect(shown(store.getState(), KEY, 20_000)).toBeNull();
});

test("the outcome of an older press does not cover a newer one", () => {
  const store = createCommands();
  const first = begin(store, KEY, "on");
  begin(store, KEY, "off");
  finish(store, KEY, first, { state: "rejected", message: null }, 1000);
  expect(shown(store.getState(), KEY, 1001)).toMatchObject({ state: "pending", asked: "off" });
});

test("controls do not see each other's commands", () => {
  const store = createCommands();
  begin(store, KEY, "on");
  expect(shown(store.getState(), "autotrim", 0)).toBeNull();
});

test.each(["confirmed", "sent"] as const)(
  "%s makes room after three seconds, to the millisecond",
  (state) => {
    const store = createCommands();
    finish(store, KEY, begin(store, KEY, "on"), { state, message: null }, 1000);
    expect(shown(store.getState(), KEY, 3999)).not.toBeNull();
    expect(shown(store.getState(), KEY, 4000)).toBeNull();
  },
);
