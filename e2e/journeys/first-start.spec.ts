import type { Page } from "@playwright/test";
import { expect, open, test } from "../support/fixtures.js";

test.use({ isNew: true });

/** Go with the Tab key to what has this name, and press it. */
async function press(page: Page, name: string): Promise<void> {
  const wanted = page.getByRole("main").getByRole("button", { name, exact: true });
  await expect(async () => {
    await page.keyboard.press("Tab");
    await expect(wanted).toBeFocused({ timeout: 1 });
  }).toPass({ intervals: [0] });
  await page.keyboard.press("Enter");
}

test("a new station is set up by keyboard alone, once", async ({ page, station }) => {
  await open(page, station);
  const step = page.getByRole("main").getByRole("heading", { level: 3 });
  await expect(step).toHaveText("Paso 1 de 4: Idioma");
  await press(page, "Siguiente");
  await expect(step).toBeFocused();
  await press(page, "Saltar este paso");
  await expect(step).toHaveText("Paso 3 de 4: Simulador");
  await press(page, "Saltar este paso");
  await press(page, "Terminar");
  await expect(page.getByRole("tablist", { name: "Pestañas principales" })).toBeVisible();
  await page.reload({ waitUntil: "domcontentloaded" });
  await expect(page.getByText("Tienes el control", { exact: true })).toBeVisible();
  await expect(page.getByRole("tablist", { name: "Pestañas principales" })).toBeVisible();
  await expect(step).toHaveCount(0);
});
