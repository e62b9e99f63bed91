import { expect, open, test } from "../support/fixtures.js";
import { GROUPS, openTab } from "../support/tabs.js";
import { settled } from "./picture.js";

const SIZES = [
  { width: 1366, height: 768 },
  { width: 1920, height: 1080 },
] as const;
const LOOKS = ["dark", "light", "sunlight"] as const;
const LANGUAGES = ["es", "en"] as const;

/** One picture of every tab and menu in every size, language and look, to be looked at: `npm run shots`. */
test("every tab and menu is pictured", async ({ page, flying }) => {
  await open(page, flying);
  await openTab(page, "Autopilot Param");
  await page.getByRole("button", { name: "Load", exact: true }).click();
  await expect(page.getByRole("textbox", { name: "k_elev", exact: true })).not.toHaveValue("");
  for (const language of LANGUAGES) {
    for (const theme of LOOKS) {
      await page.evaluate(
        ([lang, look]) => {
          const kept = JSON.parse(localStorage.getItem("epf-gcs.settings") ?? "{}");
          localStorage.setItem("epf-gcs.settings", JSON.stringify({ ...kept, language: lang, theme: look }));
        },
        [language, theme],
      );
      await page.reload({ waitUntil: "domcontentloaded" });
      await expect(page.locator("html")).toHaveAttribute("data-theme", theme);
      for (const size of SIZES) {
        await page.setViewportSize(size);
        for (const [index, tab] of Object.values(GROUPS[language]).flat().entries()) {
          await openTab(page, tab);
          await settled(page);
          const name = `${size.width}-${language}-${theme}-${index + 1}-${tab.replaceAll(" ", "-")}`;
          await page.screenshot({ path: `test-results/shots/${name}.png` });
        }
        for (const [index, menu] of (await page.getByRole("menubar").getByRole("menuitem").all()).entries()) {
          await menu.click();
          await expect(page.getByRole("menu")).toBeVisible();
          await settled(page);
          const name = `${size.width}-${language}-${theme}-menu-${index + 1}-${(await menu.textContent())?.replaceAll(" ", "-")}`;
          await page.screenshot({ path: `test-results/shots/${name}.png` });
          await page.keyboard.press("Escape");
        }
      }
    }
  }
});
