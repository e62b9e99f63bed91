import { expect, open, test } from "../support/fixtures.js";
import { ROOT } from "../support/processes.js";
import { openTab } from "../support/tabs.js";
import { keepWebp, settled } from "./picture.js";

const PICTURES = 24;
/** About a second of flight between two pictures; `docs/moving.py` plays them four times as fast. */
const WAITS = 5;

test("the page in flight, picture by picture, for the moving one of the README", async ({ page, flying }) => {
  await page.setViewportSize({ width: 1280, height: 720 });
  await open(page, flying);
  await expect(page.getByText("Tienes el control", { exact: true })).toBeVisible();
  await page
    .getByRole("group", { name: /^(Idioma|Language)$/ })
    .getByText("English")
    .click();
  await openTab(page, "HIL Standard Six");
  for (let nth = 0; nth < PICTURES; nth += 1) {
    await keepWebp(page, `${ROOT}/e2e/test-results/moving/${String(nth).padStart(2, "0")}.webp`);
    for (let wait = 0; wait < WAITS; wait += 1) await settled(page);
  }
});
