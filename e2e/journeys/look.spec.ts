import AxeBuilder from "@axe-core/playwright";
import { expect, open, test } from "../support/fixtures.js";

const TABS = ["Datos de vuelo", "HIL", "Setup"];

for (const theme of ["Oscuro", "Claro"]) {
  test(`every tab is accessible, theme ${theme}`, async ({ page, flying }) => {
    await open(page, flying);
    await page.getByRole("combobox", { name: "Aspecto" }).selectOption(theme);
    for (const name of TABS) {
      await page.getByRole("tab", { name, exact: true }).click();
      const { violations } = await new AxeBuilder({ page }).analyze();
      expect(violations.map((violation) => `${name}: ${violation.id} ${violation.nodes[0]?.html}`)).toEqual([]);
    }
  });
}

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
