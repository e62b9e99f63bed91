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

/** Close whatever menu is open. */
export async function closeMenu(page: Page): Promise<void> {
  await page.keyboard.press("Escape");
  await expect(page.getByRole("menu")).toHaveCount(0);
}
