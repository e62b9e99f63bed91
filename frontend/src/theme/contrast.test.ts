import { readFileSync } from "node:fs";
import { describe, expect, test } from "vitest";
import { THEMES, type ThemeName } from "./theme";

const css = readFileSync(new URL("./tokens.css", import.meta.url), "utf-8");

/** Colours of one theme as tokens.css declares them, by token name. */
function palette(theme: ThemeName): Map<string, string> {
  const block = css.split(`[data-theme="${theme}"] {`)[1]?.split("\n}")[0] ?? "";
  const found = block.matchAll(/(--[\w-]+):\s*(#[0-9a-f]{6});/g);
  return new Map([...found].map((match) => [match[1] ?? "", match[2] ?? ""]));
}

/** Relative luminance of `#rrggbb`, WCAG 2.2. */
function luminance(hex: string): number {
  const [red = 0, green = 0, blue = 0] = [1, 3, 5].map((start) => {
    const share = Number.parseInt(hex.slice(start, start + 2), 16) / 255;
    return share <= 0.04045 ? share / 12.92 : ((share + 0.055) / 1.055) ** 2.4;
  });
  return 0.2126 * red + 0.7152 * green + 0.0722 * blue;
}

function contrast(one: string, other: string): number {
  const [dark = 0, bright = 0] = [luminance(one), luminance(other)].sort((a, b) => a - b);
  return (bright + 0.05) / (dark + 0.05);
}

const TEXT = 4.5;
const GRAPHIC = 3;

const surfaces = ["--surface-0", "--surface-1", "--surface-2", "--surface-3", "--surface-well"];
const inks = ["--text", "--text-muted", "--accent", "--engaged", "--guidance", "--caution", "--warning"];

const pairs: [string, string, number][] = [
  ...surfaces.flatMap((surface) => inks.map((ink): [string, string, number] => [ink, surface, TEXT])),
  ...surfaces.map((surface): [string, string, number] => ["--line-control", surface, GRAPHIC]),
  ...[1, 2, 3, 4, 5, 6].map((line): [string, string, number] => [
    `--plot-${line}`,
    "--surface-well",
    GRAPHIC,
  ]),
  ["--accent-ink", "--accent", TEXT],
  ["--dial-caution-ink", "--dial-caution", TEXT],
  ["--dial-caution", "--dial-face", GRAPHIC],
  ["--alarm-ink", "--alarm", TEXT],
  ["--past-ink", "--past", TEXT],
  ...surfaces.map((surface): [string, string, number] => ["--past", surface, GRAPHIC]),
  ["--past", "--past-wash", GRAPHIC],
  ["--past", "--dial-face", GRAPHIC],
  ...inks.map((ink): [string, string, number] => [ink, "--past-wash", TEXT]),
  ["--text", "--accent-wash", TEXT],
  ["--accent", "--accent-wash", TEXT],
  ["--engaged", "--engaged-wash", TEXT],
  ["--caution", "--caution-wash", TEXT],
  ["--warning", "--warning-wash", TEXT],
  ["--text", "--caution-wash", TEXT],
  ["--text-muted", "--caution-wash", TEXT],
  ["--text", "--warning-wash", TEXT],
  ["--dial-mark", "--dial-face", TEXT],
  ["--dial-mark-minor", "--dial-face", TEXT],
  ["--dial-caption", "--dial-face", TEXT],
  ["--dial-mark", "--dial-window", TEXT],
  ["--dial-mark", "--dial-sky", TEXT],
  ["--dial-mark", "--dial-ground", TEXT],
  ["--dial-symbol", "--dial-sky", GRAPHIC],
  ["--dial-symbol", "--dial-ground", GRAPHIC],
  ["--dial-bug", "--dial-face", GRAPHIC],
  ["--dial-cross", "--dial-face", TEXT],
];

describe.each(THEMES)("the %s theme", (theme) => {
  const colours = palette(theme);

  test.each(pairs)("shows %s on %s with a contrast of at least %d", (ink, surface, least) => {
    expect(contrast(colours.get(ink) ?? "", colours.get(surface) ?? "")).toBeGreaterThanOrEqual(least);
  });
});

test("the measure of contrast agrees with the known ends and a known grey", () => {
  expect(contrast("#000000", "#ffffff")).toBeCloseTo(21, 5);
  expect(contrast("#777777", "#ffffff")).toBeCloseTo(4.48, 2);
});
