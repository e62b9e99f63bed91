import type { Locator, Page } from "@playwright/test";

/** The colours of a picture's pixels, row by row, red, green, blue and opacity in turn. */
export interface Pixels {
  readonly width: number;
  readonly height: number;
  readonly rgba: readonly number[];
}

/** What is seen of an element at this moment. */
export async function pixelsOf(page: Page, seen: Locator): Promise<Pixels> {
  return await decoded(page, await seen.screenshot());
}

/** The colour at a place of the window. A picture of all of it would keep the test, and so its cable, busy for long. */
export async function colourAt(page: Page, x: number, y: number): Promise<readonly number[]> {
  const { rgba } = await decoded(page, await page.screenshot({ clip: { x, y, width: 1, height: 1 } }));
  return rgba.slice(0, 3);
}

async function decoded(page: Page, picture: Buffer): Promise<Pixels> {
  return await page.evaluate(async (base64) => {
    const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
    const bitmap = await createImageBitmap(new Blob([bytes], { type: "image/png" }));
    const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
    const context = canvas.getContext("2d");
    if (context === null) throw new Error("no canvas to read the picture from");
    context.drawImage(bitmap, 0, 0);
    const { data } = context.getImageData(0, 0, bitmap.width, bitmap.height);
    return { width: bitmap.width, height: bitmap.height, rgba: [...data] };
  }, picture.toString("base64"));
}

/** The part of a picture's pixels for which this holds, 0..1. */
export function partOf({ rgba }: Pixels, holds: (red: number, green: number, blue: number) => boolean): number {
  let count = 0;
  for (let at = 0; at < rgba.length; at += 4) {
    count += holds(rgba[at] ?? 0, rgba[at + 1] ?? 0, rgba[at + 2] ?? 0) ? 1 : 0;
  }
  return (4 * count) / rgba.length;
}

/** The colour in the middle. */
export function middleOf({ width, height, rgba }: Pixels): readonly number[] {
  const at = 4 * (Math.floor(height / 2) * width + Math.floor(width / 2));
  return rgba.slice(at, at + 3);
}
