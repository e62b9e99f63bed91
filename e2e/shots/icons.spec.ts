import { readFile } from "node:fs/promises";
import { expect, test } from "@playwright/test";
import { ROOT } from "../support/processes.js";

/**
 * The icons of the installed page, drawn from its one SVG. A mask may cut off all but a circle of 80 %: the drawing is
 * made smaller, on a ground that fills the corners.
 */
const ICONS = [
  { file: "192.png", size_px: 192, isMasked: false },
  { file: "512.png", size_px: 512, isMasked: false },
  { file: "maskable-512.png", size_px: 512, isMasked: true },
] as const;

/** Colour of the SVG's own ground. */
const GROUND = "#0e1214";

for (const { file, size_px, isMasked } of ICONS) {
  test(`${file} is drawn from icon.svg`, async ({ page }) => {
    const drawn = await readFile(`${ROOT}/frontend/public/icon.svg`, "utf8");
    const svg = isMasked ? drawn.replace('viewBox="0 0 32 32"', 'viewBox="-2 -2 36 36"') : drawn;
    expect(svg === drawn).toBe(!isMasked);
    await page.setViewportSize({ width: size_px, height: size_px });
    await page.setContent(
      `<style>body{margin:0;background:${isMasked ? GROUND : "none"}}svg{display:block;width:${size_px}px;height:${size_px}px}</style>${svg}`,
    );
    const path = `${ROOT}/frontend/public/icons/${file}`;
    await page.screenshot({ path, omitBackground: !isMasked });
  });
}
