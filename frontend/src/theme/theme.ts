/** The three looks of tokens.css: a dark panel, daylight, and outdoors in the sun. */
export const THEMES = ["dark", "light", "sunlight"] as const;

export type ThemeName = (typeof THEMES)[number];

/** Whether a value from outside (storage, address) names a theme. */
export function isThemeName(value: unknown): value is ThemeName {
  return THEMES.some((name) => name === value);
}

/** Dress `root` (the document's element, or any part of it) in a theme. */
export function applyTheme(root: HTMLElement, name: ThemeName): void {
  root.dataset["theme"] = name;
}
