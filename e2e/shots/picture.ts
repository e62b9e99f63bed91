import { mkdir, writeFile } from "node:fs/promises";
import path from "node:path";
import type { Page } from "@playwright/test";

/** Wait until what was asked for stands still on the screen: a dozen animation frames, and the ten looks a second at text. */
export async function settled(page: Page): Promise<void> {
  await page.evaluate(async () => {
    await document.fonts.ready;
    for (let nth = 0; nth < 12; nth += 1) await new Promise((done) => requestAnimationFrame(done));
  });
}

/** The page as WebP, a quarter of the size of a PNG: these are kept in the repository. */
export async function keepWebp(page: Page, file: string): Promise<void> {
  const devtools = await page.context().newCDPSession(page);
  const { data } = await devtools.send("Page.captureScreenshot", { format: "webp", quality: 70 });
  await devtools.detach();
  await mkdir(path.dirname(file), { recursive: true });
  await writeFile(file, Buffer.from(data, "base64"));
}
