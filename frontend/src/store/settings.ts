import { createStore, type StoreApi } from "zustand/vanilla";
import { isObject, isText } from "../lib/check";
import { isThemeName, type ThemeName } from "../theme/theme";

export const LANGUAGES = ["es", "en"] as const;
export type Language = (typeof LANGUAGES)[number];

/** The settings stored in this browser. `choices` are small values by name: the last open tab, a field's last text. */
export interface Settings {
  readonly language: Language;
  readonly theme: ThemeName;
  readonly choices: Readonly<Record<string, string>>;
}

export type SettingsStore = StoreApi<Settings>;

/** The part of localStorage that is used; it may throw when the browser forbids it. */
export interface BrowserStorage {
  getItem(key: string): string | null;
  setItem(key: string, value: string): void;
}

/** The first language of ours that the browser prefers; English for everybody else. */
export function preferredLanguage(tags: readonly string[]): Language {
  const wanted = tags.map((tag) => tag.split("-")[0]?.toLowerCase());
  return wanted.map((tag) => LANGUAGES.find((known) => known === tag)).find(isKnown) ?? "en";
}

const KEY = "epf-gcs.settings";

/**
 * The settings, written to the storage at each change; without a usable storage they last as long as the page.
 * `preferred` are the browser's languages: they hold until a person chooses another one.
 */
export function createSettings(storage: BrowserStorage | null, preferred: readonly string[]): SettingsStore {
  const { language: kept, ...others } = read(storage);
  const first = kept ?? preferredLanguage(preferred);
  const store = createStore<Settings>(() => ({ language: first, ...others }));
  let isChosen = kept !== undefined;
  store.subscribe(({ language, ...changed }) => {
    isChosen ||= language !== first;
    try {
      storage?.setItem(KEY, JSON.stringify(isChosen ? { language, ...changed } : changed));
    } catch {
      // Full or forbidden: the page works without storage.
    }
  });
  return store;
}

export function choose(store: SettingsStore, name: string, value: string): void {
  store.setState(({ choices }) => ({ choices: { ...choices, [name]: value } }));
}

function isKnown(language: Language | undefined): language is Language {
  return language !== undefined;
}

/** What is stored; the language only if it was chosen. */
function read(
  storage: BrowserStorage | null,
): Omit<Settings, "language"> & { language: Language | undefined } {
  const stored = parse(storage);
  const { choices, language, theme } = stored;
  return {
    language: LANGUAGES.find((known) => known === language),
    theme: isThemeName(theme) ? theme : "dark",
    choices: isObject(choices)
      ? Object.fromEntries(
          Object.entries(choices)
            .filter((entry): entry is [string, string] => isText(entry[1]))
            .map(renamed),
        )
      : {},
  };
}

/** A stored choice of an earlier version, which called the aircraft in flight "real". */
function renamed([name, value]: [string, string]): [string, string] {
  if (name === "map.track.real") {
    return ["map.track.flight", value];
  }
  return [name, name === "tuning.aircraft" && value === "real" ? "flight" : value];
}

function parse(storage: BrowserStorage | null): Readonly<Record<string, unknown>> {
  try {
    const value: unknown = JSON.parse(storage?.getItem(KEY) ?? "null");
    return isObject(value) ? value : {};
  } catch {
    return {};
  }
}
