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

/** Nobody waits so long for the request of a press but where there is none. */
const REQUEST_MS = 10_000;

/**
 * Press a switch until its command is asked for. A heartbeat that comes late disables the switch for a moment; where that
 * is the very moment of the press, nothing happens, as for a user, who presses again.
 */
export async function press(page: Page, entry: Locator): Promise<void> {
  const asked = page.waitForRequest(/\/api\/v1\/commands\//).then(() => true);
  do await entry.click();
  while (!(await Promise.race([asked, after(REQUEST_MS)])));
}

async function after(ms: number): Promise<false> {
  return await new Promise((resolve) => setTimeout(() => resolve(false), ms));
}

/** Close whatever menu is open. */
export async function closeMenu(page: Page): Promise<void> {
  await page.keyboard.press("Escape");
  await expect(page.getByRole("menu")).toHaveCount(0);
}
