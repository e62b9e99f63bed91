import type { Locator, Page } from "@playwright/test";
import { MENUS } from "../checklist/menus.js";
import { FRAME, type Part, SCREENS, type Screen } from "../checklist/screens.js";
import { expect, open, test } from "../support/fixtures.js";
import { closeMenu, entryOf, openMenu } from "../support/menu.js";
import { openTab } from "../support/tabs.js";
import { ANY_STATION } from "../support/there.js";

/** Each finding is noted and the walk goes on, so that one run tells all that is missing. */
const there = expect.configure({ soft: true, timeout: 60_000 });

/** One part as the open tab has it: visible, with its words, and with a reason where it is disabled. */
async function findsIn(panel: Locator, { role, name, reads = [], count }: Part, what: string): Promise<void> {
  const found = panel.getByRole(role, typeof name === "string" ? { name, exact: true } : { name });
  await there(found, `${what}: ${role} ${name}`).toHaveCount(count ?? 1);
  for (const words of reads) await there(found, `${what}: ${name}`).toContainText(words);
  for (const each of await found.all()) {
    await there(each, `${what}: ${role} ${name}`).toBeVisible();
    await saysWhyItIsDisabled(each, `${what}: ${name}`);
  }
}

/** A control that cannot be used has a description, and that is a sentence. */
async function saysWhyItIsDisabled(control: Locator, what: string): Promise<void> {
  if ((await control.getAttribute("aria-disabled")) === "true") {
    await there(control, `${what}, disabled`).toHaveAccessibleDescription(/\S+ \S+/);
  }
}

async function show(page: Page, { tab, sub }: Screen): Promise<void> {
  await openTab(page, tab);
  if (sub !== undefined) await page.getByRole("tabpanel").getByRole("tab", { name: sub, exact: true }).click();
}

test("everything of the check list is there, enabled or with the reason why not", { tag: ANY_STATION }, async ({
  page,
  flying,
}) => {
  await open(page, flying);
  await expect(page.getByText("Tienes el control", { exact: true })).toBeVisible();

  await test.step("the frame", async () => {
    for (const part of FRAME) {
      const found = page.getByRole(part.role, { name: part.name, exact: true }).first();
      await there(found, `${part.role} ${part.name}`).toBeVisible();
      for (const words of part.reads ?? []) await there(found, `${part.name}`).toContainText(words);
    }
  });

  for (const screen of SCREENS) {
    const what = [screen.tab, screen.sub].filter((name) => name !== undefined).join(" › ");
    await test.step(what, async () => {
      await show(page, screen);
      const panel = page.getByRole("tabpanel", { name: screen.tab, exact: true });
      await expect(panel).toBeVisible();
      for (const part of screen.parts) await findsIn(panel, part, what);
    });
  }

  for (const menu of MENUS) {
    await test.step(menu.name, async () => {
      await openMenu(page, menu.name);
      for (const entry of menu.entries) {
        const found = entryOf(page, entry);
        await there(found, `${menu.name}: ${entry.name}`).toBeVisible();
        if (entry.reason !== undefined) {
          await there(found, `${menu.name}: ${entry.name}`).toBeDisabled();
        } else if ((await found.count()) > 0) {
          await saysWhyItIsDisabled(found, `${menu.name}: ${entry.name}`);
        }
      }
      await closeMenu(page);
    });
  }
});
