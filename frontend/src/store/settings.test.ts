import { expect, test } from "vitest";
import { type BrowserStorage, choose, createSettings } from "./settings";

class MemoryStorage implements BrowserStorage {
  readonly kept = new Map<string, string>();
  getItem(key: string): string | null {
    return this.kept.get(key) ?? null;
  }
  setItem(key: string, value: string): void {
    this.kept.set(key, value);
  }
}

test("a first visit is in Spanish and dark", () => {
  expect(createSettings(new MemoryStorage()).getState()).toEqual({
    language: "es",
    theme: "dark",
    choices: {},
  });
});

test("what was chosen is there after a reload", () => {
  const storage = new MemoryStorage();
  const before = createSettings(storage);
  before.setState({ language: "en", theme: "light" });
  choose(before, "tab", "setup");
  choose(before, "board.device", "tcp://127.0.0.1:5760");
  expect(createSettings(storage).getState()).toEqual({
    language: "en",
    theme: "light",
    choices: { tab: "setup", "board.device": "tcp://127.0.0.1:5760" },
  });
});

test("what an earlier version kept of the aircraft in flight is still chosen", () => {
  const storage = new MemoryStorage();
  const choices = { "map.track.real": "off", "tuning.aircraft": "real" };
  storage.setItem("epf-gcs.settings", JSON.stringify({ choices }));
  expect(createSettings(storage).getState().choices).toEqual({
    "map.track.flight": "off",
    "tuning.aircraft": "flight",
  });
});

test.each(["not JSON", "[]", "null", '{"language":"fr","theme":7,"choices":{"tab":1}}'])(
  "a spoilt memory (%s) is a first visit",
  (text) => {
    const storage = new MemoryStorage();
    storage.setItem("epf-gcs.settings", text);
    expect(createSettings(storage).getState()).toEqual({ language: "es", theme: "dark", choices: {} });
  },
);

test("a browser that forbids its memory still has settings", () => {
  const store = createSettings({
    getItem: () => {
      throw new DOMException("forbidden", "SecurityError");
    },
    setItem: () => {
      throw new DOMException("forbidden", "SecurityError");
    },
  });
  store.setState({ language: "en" });
  expect(store.getState().language).toBe("en");
});

test("a choice leaves the others alone, and only the aircraft's own choice had another name", () => {
  const storage = new MemoryStorage();
  const choices = { "tuning.aircraft": "hil", "plans.kind": "real" };
  storage.setItem("epf-gcs.settings", JSON.stringify({ choices }));
  const settings = createSettings(storage);
  choose(settings, "tab", "map");
  expect(settings.getState().choices).toEqual({ ...choices, tab: "map" });
});

test("without any memory there are settings for as long as the page lasts", () => {
  const settings = createSettings(null);
  choose(settings, "tab", "map");
  expect(settings.getState()).toEqual({ language: "es", theme: "dark", choices: { tab: "map" } });
});
