import type { Locator, Page } from "@playwright/test";
import { expect, open, test } from "../support/fixtures.js";
import { openTab } from "../support/tabs.js";

const SIZES = [
  { width: 1366, height: 768 },
  { width: 768, height: 1024 },
  { width: 390, height: 844 },
];

type Boxes = Record<string, readonly number[]>;

/** Place and size of everything that can be pressed, but in the alarms' own place: `name` to left, top, width, height. */
async function boxes(page: Page): Promise<Boxes> {
  return await page.evaluate(() => {
    const found: Record<string, number[]> = {};
    for (const one of document.querySelectorAll(
      "button, [role=menuitem], [role=tab], input, select, .ui-switch-option",
    )) {
      const { x, y, width, height } = one.getBoundingClientRect();
      // What is scrolled out of sight is under no finger.
      const isSeen = y < window.innerHeight && one.checkVisibility();
      if (isSeen && one.closest(".ui-alarms") === null) {
        const name = `${one.tagName} ${one.getAttribute("aria-label") ?? one.textContent}`;
        let key = name;
        for (let count = 2; key in found; count += 1) key = `${name} ${count}`;
        found[key] = [x, y, width, height].map(Math.round);
      }
    }
    return found;
  });
}

/** A finger does not notice less: a letter is wider in bold. */
const NOTICED_PX = 2;

/** What stands elsewhere, or has another size, than before. */
function moved(before: Boxes, after: Boxes): string[] {
  return Object.entries(before).flatMap(([name, box]) => {
    const now = after[name];
    const isThere = now === undefined || box.every((edge, at) => Math.abs(edge - (now[at] ?? 0)) <= NOTICED_PX);
    return isThere ? [] : [`${name}: ${box} became ${now}`];
  });
}

/** Acknowledge what has ended until there is no alarm: a pulled line, or a busy computer, opens the HIL loop too. */
async function acknowledgeAll(alarms: Locator): Promise<void> {
  const ended = alarms.getByRole("button", { name: /^Reconocer que terminó/ });
  await expect
    .poll(async () => {
      // At once, and only what is there: a press that waits for a button waits for ever once the last one is gone.
      await ended.evaluateAll((buttons: HTMLElement[]) => {
        for (const button of buttons) button.click();
      });
      return await alarms.innerText();
    })
    .toContain("Ninguna alarma");
}

for (const size of SIZES) {
  test(`nothing that can be pressed moves when an alarm comes, lasts and ends (${size.width})`, async ({
    page,
    flying,
  }) => {
    await page.setViewportSize(size);
    await open(page, flying);
    const alarms = page.getByRole("region", { name: "Alarmas" });
    for (const tab of ["Vista de vuelo", "Planes de vuelo"]) {
      await openTab(page, tab);
      await expect(page.getByRole("tabpanel", { name: tab }).getByRole("button").first()).toBeVisible();
      await acknowledgeAll(alarms);
      const before = await boxes(page);
      expect(Object.keys(before).length).toBeGreaterThan(10);
      await flying.line.pull();
      await expect(alarms.getByRole("alert")).toContainText("Se ha perdido el latido de la placa");
      expect(moved(before, await boxes(page)), `${tab}, while it lasts`).toEqual([]);
      await flying.line.plugIn();
      const ended = alarms.getByRole("listitem").filter({ hasText: "latido perdido" });
      await expect(ended).toBeVisible();
      expect(moved(before, await boxes(page)), `${tab}, when it has ended`).toEqual([]);
    }
  });
}

test("a tick of success leaves each button where it is, and as wide as it is", async ({ page, flying }) => {
  await open(page, flying);
  await openTab(page, "Planes de vuelo");
  await page.getByRole("tab", { name: "Plan HIL" }).click();
  const panel = page.getByRole("tabpanel", { name: "Plan HIL" });
  const read: Locator = panel.getByRole("button", { name: "Descargar de la placa" });
  const before = await boxes(page);
  await read.click();
  await expect(read.locator("[data-state=confirmed] svg")).toBeVisible();
  const after = await boxes(page);
  // The plan that was read may have another height: its toolbar and what is above are what a hand may be over.
  const toolbar = await panel.getByRole("toolbar").first().boundingBox();
  const edge_px = (toolbar?.y ?? 0) + (toolbar?.height ?? 0);
  const above = Object.fromEntries(Object.entries(before).filter(([, [, top = 0]]) => top < edge_px));
  expect(Object.keys(above)).toContain("BUTTON Importar");
  expect(moved(above, after)).toEqual([]);
});
