import { expect, open, test } from "../support/fixtures.js";

test("language and theme are one click away and remembered", async ({ page, flying }) => {
  await open(page, flying);
  await page.getByRole("group", { name: "Idioma" }).getByText("English").click();
  await expect(page.getByRole("tab", { name: "Flight data" })).toBeVisible();
  await page.getByRole("combobox", { name: "Look" }).selectOption("Light");
  await page.reload({ waitUntil: "domcontentloaded" });
  await expect(page.getByRole("tab", { name: "Flight data" })).toBeVisible();
  await expect(page.locator("html")).toHaveAttribute("data-theme", "light");
  await expect(page.locator("html")).toHaveAttribute("lang", "en");
});
