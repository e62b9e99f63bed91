import type { Page } from "@playwright/test";
import { expect, open, test } from "../support/fixtures.js";
import { GROUPS, openTab } from "../support/tabs.js";

/** More stops than any tab has: a walk that does not end in so many is caught somewhere. */
const STOPS_MOST = 250;

interface Stop {
  readonly what: string;
  readonly isSeen: boolean;
  readonly isInPanel: boolean;
}

/** Where the focus is: what is hidden for eyes (a radio button) counts by the label around it. */
async function stop(page: Page): Promise<Stop | null> {
  return await page.evaluate(() => {
    const focused = document.activeElement;
    if (focused === null || focused === document.body) return null;
    const shown = focused.closest("label") ?? focused;
    const { width, height } = shown.getBoundingClientRect();
    const name = focused.getAttribute("aria-label") ?? shown.textContent ?? "";
    return {
      what: `${focused.tagName} ${focused.id} ${name.trim().slice(0, 40)}`,
      isSeen: width > 1 && height > 1 && shown.checkVisibility({ visibilityProperty: true, opacityProperty: true }),
      isInPanel: focused.closest("[role=tabpanel]") !== null,
    };
  });
}

/** Go once round the page with the Tab key. */
async function walk(page: Page, tab: string): Promise<void> {
  await page.evaluate(() => (document.activeElement as HTMLElement | null)?.blur());
  const stops: Stop[] = [];
  let nowhere = 0;
  for (let press = 0; press < STOPS_MOST; press += 1) {
    await page.keyboard.press("Tab");
    const at = await stop(page);
    if (at === null) {
      // Behind the last stop the focus leaves the page. An alarm that ends takes its focused button with it as well,
      // however often: then the next press goes on beside its place.
      nowhere += 1;
      if (nowhere > 1 || stops.some(({ isInPanel }) => isInPanel)) break;
      continue;
    }
    nowhere = 0;
    if (stops.length > 3 && at.what === stops[0]?.what) break;
    stops.push(at);
  }
  expect(stops.length, `${tab}: the walk ends`).toBeLessThan(STOPS_MOST);
  expect(
    stops.filter(({ isSeen }) => !isSeen).map(({ what }) => what),
    `${tab}: each stop can be seen`,
  ).toEqual([]);
  expect(
    stops.some(({ isInPanel }) => isInPanel),
    `${tab}: its contents are in reach`,
  ).toBe(true);
}

test("a pilot without a mouse reaches every tab, switches the autopilot, writes a gain and knows of an alarm", async ({
  page,
  flying,
}) => {
  await open(page, flying);
  await expect(page.getByText("Tienes el control", { exact: true })).toBeVisible();
  const said = page.getByRole("status", { name: "Último mensaje" });

  const bar = page.getByRole("tablist", { name: "Pestañas principales" }).getByRole("tab");
  expect(await bar.allTextContents()).toEqual(Object.keys(GROUPS.es));
  // Each digit opens the tabs of its group in turn; from the last one of the first group that is its first.
  await openTab(page, "Standard Six");
  for (const [place, tabs] of Object.values(GROUPS.es).entries()) {
    for (const tab of tabs) {
      await page.evaluate(() => (document.activeElement as HTMLElement | null)?.blur());
      await page.keyboard.press(`${place + 1}`);
      await expect(page.getByRole("tabpanel", { name: tab, exact: true }).first()).toBeVisible();
      await expect(page.locator(".app-waiting"), `${tab} is loaded`).toHaveCount(0);
      await walk(page, tab);
    }
  }

  await test.step("menu", async () => {
    await page.getByRole("menubar").getByRole("menuitem", { name: "Autopilot", exact: true }).focus();
    await page.keyboard.press("ArrowRight");
    await page.keyboard.press("Enter");
    const entry = page.getByRole("menuitemcheckbox", { name: "Sensores Inerciales", exact: true });
    await expect(entry).toBeChecked();
    await page.keyboard.press("Escape");
    await expect(page.getByRole("menu")).toHaveCount(0);
    await expect(page.getByRole("menubar").getByRole("menuitem", { name: "Parámetros", exact: true })).toBeFocused();
  });

  await test.step("a command needs its second key", async () => {
    await page.evaluate(() => (document.activeElement as HTMLElement | null)?.blur());
    await page.keyboard.press("Shift+A");
    await page.keyboard.press("Enter");
    await expect(said).toContainText("Autopilot Off: confirmado");
    await page.keyboard.press("a");
    await page.keyboard.press("Enter");
    await expect(said).toContainText("Autopilot On: confirmado");
  });

  await test.step("a gain", async () => {
    await page.keyboard.press("3");
    await page.getByRole("button", { name: "Load", exact: true }).press("Enter");
    const gain = page.getByRole("textbox", { name: "k_elev", exact: true });
    await expect(gain).not.toHaveValue("");
    const before = Number(await gain.inputValue());
    await gain.press("ArrowUp");
    await expect(said).toContainText("confirmado por relectura");
    expect(Number(await gain.inputValue())).toBeGreaterThan(before);
    await page.getByRole("button", { name: /^Deshacer/ }).press("Enter");
    await expect(gain).toHaveValue(`${before}`);
  });

  await test.step("an alarm", async () => {
    await page.evaluate(() => (document.activeElement as HTMLElement | null)?.blur());
    await openTab(page, "Alarmas");
    const limit = page.getByRole("region", { name: "Umbrales" }).getByRole("textbox", { name: /^Batería baja/ });
    await limit.fill("60");
    await limit.press("Enter");
    await expect(page.getByRole("region", { name: "Alarmas" }).getByRole("alert")).toContainText("Batería baja");
    await page
      .getByRole("region", { name: "Alarmas" })
      .getByRole("button", { name: /^Reconocer: Batería/ })
      .press("Enter");
    const acknowledged = async () =>
      (await flying.status()).alarms.some(
        (alarm: { id: string; acknowledged: boolean }) => alarm.id === "battery_low" && alarm.acknowledged,
      );
    await expect.poll(acknowledged).toBe(true);
    await expect(page.getByRole("region", { name: "Activas" })).toContainText("reconocida");
  });

  await test.step("windows", async () => {
    await page.evaluate(() => (document.activeElement as HTMLElement | null)?.blur());
    await page.keyboard.press("?");
    await expect(page.getByRole("dialog")).toBeVisible();
    await page.keyboard.press("Escape");
    await expect(page.getByRole("dialog")).toHaveCount(0);
  });
});
