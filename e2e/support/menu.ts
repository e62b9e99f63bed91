import { expect, type Locator, type Page } from "@playwright/test";
import type { Entry } from "../checklist/menus.js";

/** Open a menu of the menu bar. */
export async function openMenu(page: Page, name: string): Promise<void> {
  await page.getByRole("menubar").getByRole("menuitem", { name, exact: true }).click();
  await expect(page.getByRole("menu")).toBeVisible();
}

/** An entry of the open menu. */
export function entryOf(page: Page, { role, name, group, reason }: Entry): Locator {
  const menu = page.getByRole("menu");
  return (group === undefined ? menu : menu.getByRole("group", { name: group, exact: true })).getByRole(role, {
    name: reason === undefined ? name : `${name} ${reason}`,
    exact: true,
  });
}

/** A press that is heard has asked for its command long before. */
const REQUEST_MS = 10_000;

/**
 * Press a switch, and wait until its command is asked for. A late heartbeat disables the switch for a moment. If that is
 * the moment of the press, nothing happens, and it is pressed once more, as a user would.
 */
export async function press(page: Page, entry: Locator): Promise<void> {
  const asked = page.waitForRequest(/\/api\/v1\/commands\//).then(() => true);
  await entry.click();
  const isAsked = await Promise.race([asked, page.waitForTimeout(REQUEST_MS).then(() => false)]);
  if (!isAsked) await entry.click();
  await asked;
}

/** Close whatever menu is open. */
export async function closeMenu(page: Page): Promise<void> {
  await page.keyboard.press("Escape");
  await expect(page.getByRole("menu")).toHaveCount(0);
}
