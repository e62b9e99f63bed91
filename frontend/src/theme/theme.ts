/** The three themes of tokens.css: dark, light, and for sunlight outdoors. */
export const THEMES = ["dark", "light", "sunlight"] as const;

export type ThemeName = (typeof THEMES)[number];

/** Whether a value from outside (storage, address) names a theme. */
export function isThemeName(value: unknown): value is ThemeName {
  return THEMES.some((name) => name === value);
}

/** Apply a theme to `root` (the document's element, or a part of it). */
export function applyTheme(root: HTMLElement, name: ThemeName): void {
  root.dataset["theme"] = name;
}
