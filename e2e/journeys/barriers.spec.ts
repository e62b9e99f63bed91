import AxeBuilder from "@axe-core/playwright";
import type { Page } from "@playwright/test";
import { expect, open, test } from "../support/fixtures.js";
import { openMenu } from "../support/menu.js";
import { openTab, TABS } from "../support/tabs.js";
import { ANY_STATION } from "../support/there.js";

/** What the page breaks of the rules of accessibility, as it stands. `rules`: only these. */
async function barriers(page: Page, what: string, rules: readonly string[] = []): Promise<string[]> {
  const broken = await brokenRules(page, rules);
  if (broken.length === 0) return [];
  // The page corrects itself with the next picture that is drawn, which a busy machine draws late: what counts is what
  // is still so afterwards.
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
  const still = await brokenRules(
    page,
    broken.map(({ id }) => id),
  );
  return still.map(({ id, html }) => `${what}: ${id} ${html}`);
}

async function brokenRules(page: Page, rules: readonly string[]) {
  // All of the page is of one origin: no second browser page is needed to look into it.
  // A menu's focus guards are meant to be hidden and in the tab order: they hand the focus on where it belongs.
  // Half a megabyte of rules, read by the page once.
  const isThere = await page.evaluate(() => "axe" in window);
  const axe = new AxeBuilder({ page, ...(isThere ? { axeSource: ";" } : {}) })
    .setLegacyMode()
    .exclude("[data-base-ui-focus-guard]");
  const only: Parameters<AxeBuilder["options"]>[0] =
    rules.length === 0 ? {} : { runOnly: { type: "rule", values: [...rules] } };
  const { violations } = await axe.options({ ...only, resultTypes: ["violations"] }).analyze();
  return violations.map(({ id, nodes }) => ({ id, html: nodes[0]?.html }));
}

test("nothing keeps people out: every tab and window, in every look", { tag: ANY_STATION }, async ({
  page,
  flying,
}) => {
  await open(page, flying);
  const found: string[] = [];
  for (const look of ["Oscuro", "Claro", "Sol"]) {
    await page.getByRole("combobox", { name: "Aspecto" }).selectOption(look);
    for (const tab of TABS) {
      await openTab(page, tab);
      // Names and roles are the same in every look; colours are not.
      const rules = look === "Oscuro" ? [] : ["color-contrast"];
      found.push(...(await barriers(page, `${look}, ${tab}`, rules)));
    }
  }
  for (const [menu, window] of [
    ["Ver", "Ajustes"],
    ["Ayuda", "Guía"],
    ["Ayuda", "Atajos de teclado"],
    ["Ayuda", "Acerca de"],
  ] as const) {
    await openMenu(page, menu);
    found.push(...(await barriers(page, `menu ${menu}`)));
    await page.getByRole("menu").getByRole("menuitem", { name: window, exact: true }).click();
    await expect(page.getByRole("dialog")).toBeVisible();
    found.push(...(await barriers(page, window)));
    await page.keyboard.press("Escape");
    await expect(page.getByRole("dialog")).toHaveCount(0);
  }
  expect(found).toEqual([]);
});
