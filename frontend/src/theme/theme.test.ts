// @vitest-environment jsdom
// @vitest-environment jsdom
import { expect, test } from "vitest";
import { applyTheme, isThemeName, THEMES } from "./theme";

test("every theme can be put on an element and replaces the one before", () => {
  const root = document.createElement("div");
  for (const name of THEMES) {
    applyTheme(root, name);
    expect(root.getAttribute("data-theme")).toBe(name);
  }
});

test("only the known names are themes", () => {
  expect(THEMES.every(isThemeName)).toBe(true);
  for (const stranger of ["", "Dark", "neon", null, undefined, 3, {}]) {
    expect(isThemeName(stranger)).toBe(false);
  }
});
