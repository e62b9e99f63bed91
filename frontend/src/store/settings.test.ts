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

test.each([
  [["es-ES", "es", "en"], "es"],
  [["ES-mx"], "es"],
  [["ca-ES", "es-ES", "en"], "es"],
  [["en-US", "es"], "en"],
  [["de-DE", "fr"], "en"],
  [["est"], "en"],
  [[], "en"],
] as const)("a first visit is in the browser's language (%j): %s", (languages, language) => {
  expect(createSettings(new MemoryStorage(), languages).getState().language).toBe(language);
});

test("a language that a person chose is kept whatever the browser prefers", () => {
  const storage = new MemoryStorage();
  createSettings(storage, ["es"]).setState({ language: "en" });
  expect(createSettings(storage, ["es"]).getState().language).toBe("en");
  const again = createSettings(storage, ["es"]);
  again.setState({ language: "es" });
  expect(createSettings(storage, ["en"]).getState().language).toBe("es");
});

test("a language that nobody chose follows the browser, whatever else was chosen", () => {
  const storage = new MemoryStorage();
  choose(createSettings(storage, ["es"]), "tab", "map");
  expect(createSettings(storage, ["en"]).getState()).toMatchObject({
    language: "en",
    choices: { tab: "map" },
  });
});

test("a first visit is dark", () => {
  expect(createSettings(new MemoryStorage(), ["es"]).getState()).toEqual({
    language: "es",
    theme: "dark",
    choices: {},
  });
});

test("what was chosen is there after a reload", () => {
  const storage = new MemoryStorage();
  const before = createSettings(storage, ["es"]);
  before.setState({ language: "en", theme: "light" });
  choose(before, "tab", "setup");
  choose(before, "board.device", "tcp://127.0.0.1:5760");
  expect(createSettings(storage, ["es"]).getState()).toEqual({
    language: "en",
    theme: "light",
    choices: { tab: "setup", "board.device": "tcp://127.0.0.1:5760" },
  });
});

test("what an earlier version kept of the aircraft in flight is still chosen", () => {
  const storage = new MemoryStorage();
  const choices = { "map.track.real": "off", "tuning.aircraft": "real" };
  storage.setItem("epf-gcs.settings", JSON.stringify({ choices }));
  expect(createSettings(storage, ["es"]).getState().choices).toEqual({
    "map.track.flight": "off",
    "tuning.aircraft": "flight",
  });
});

test.each(["not JSON", "[]", "null", '{"language":"fr","theme":7,"choices":{"tab":1}}'])(
  "a spoilt memory (%s) is a first visit",
  (text) => {
    const storage = new MemoryStorage();
    storage.setItem("epf-gcs.settings", text);
    expect(createSettings(storage, ["es"]).getState()).toEqual({
      language: "es",
      theme: "dark",
      choices: {},
    });
  },
);

test("a browser that forbids its memory still has settings", () => {
  const store = createSettings(
    {
      getItem: () => {
        throw new DOMException("forbidden", "SecurityError");
      },
      setItem: () => {
        throw new DOMException("forbidden", "SecurityError");
      },
    },
    ["es"],
  );
  store.setState({ language: "en" });
  expect(store.getState().language).toBe("en");
});

test("a choice leaves the others alone, and only the aircraft's own choice had another name", () => {
  const storage = new MemoryStorage();
  const choices = { "tuning.aircraft": "hil", "plans.kind": "real" };
  storage.setItem("epf-gcs.settings", JSON.stringify({ choices }));
  const settings = createSettings(storage, ["es"]);
  choose(settings, "tab", "map");
  expect(settings.getState().choices).toEqual({ ...choices, tab: "map" });
});

test("without any memory there are settings for as long as the page lasts", () => {
  const settings = createSettings(null, ["es"]);
  choose(settings, "tab", "map");
  expect(settings.getState()).toEqual({ language: "es", theme: "dark", choices: { tab: "map" } });
});
