import { expect, open, test } from "../support/fixtures.js";
import { openMenu } from "../support/menu.js";
import { openTab } from "../support/tabs.js";
import { ANY_STATION } from "../support/there.js";
import { Walk } from "../support/walk.js";

test("language and theme are one click away and remembered", { tag: ANY_STATION }, async ({ page, flying }) => {
  await open(page, flying);
  await page.getByRole("group", { name: "Idioma" }).getByText("English").click();
  await expect(page.getByRole("tab", { name: "Flight data" })).toBeVisible();
  await page.getByRole("combobox", { name: "Look" }).selectOption("Light");
  await page.reload({ waitUntil: "domcontentloaded" });
  await expect(page.getByRole("tab", { name: "Flight data" })).toBeVisible();
  await expect(page.locator("html")).toHaveAttribute("data-theme", "light");
  await expect(page.locator("html")).toHaveAttribute("lang", "en");
});

test("what is said beside a gain lies clear of its buttons, in a narrow window too", async ({ page, station }) => {
  await station.openBoard();
  await open(page, station);
  await openTab(page, "Autopilot Param");
  await page.getByRole("button", { name: "Load", exact: true }).click();
  for (const name of ["k_elev", "k_roll"]) {
    const field = page.getByRole("textbox", { name, exact: true });
    await expect(field).not.toHaveValue("");
    await field.fill("12.5");
    await field.press("Enter");
    const reset = page.getByRole("button", { name: `Poner ${name} en su valor por defecto` });
    for (const said of ["≠ defecto", "≠ carga"]) {
      const mark = page.locator(`[data-parameter="${name}"]`).getByText(said);
      await expect(mark).toBeVisible();
      const [left, right] = [await mark.boundingBox(), await reset.boundingBox()];
      if (left === null || right === null) throw new Error(`${said} or the button of ${name} is not shown`);
      const isClear = left.x + left.width <= right.x || left.y >= right.y + right.height;
      expect(isClear, `${said} of ${name}`).toBe(true);
    }
  }
});

test("with every stream off nothing is cut, and a menu's entries stay in their places while notes come and go", async ({
  page,
  station,
}) => {
  await station.openBoard();
  await open(page, station);
  const walk = await Walk.of(page);
  expect(await walk.look("every stream is off")).toEqual([]);
  await openMenu(page, "Parámetros");
  const menu = page.getByRole("menu");
  const places = async () =>
    await menu.getByRole("menuitemcheckbox").evaluateAll((all) => all.map((one) => one.getBoundingClientRect().top));
  const gps = menu.getByRole("menuitemcheckbox", { name: "GPS", exact: true });
  await expect(gps).toBeEnabled();
  await expect(menu.locator(".ui-menu-note")).toHaveCount(0);
  const before = await places();
  await gps.click();
  await expect(gps).toContainText("confirmado");
  expect(await places()).toEqual(before);
  // Its line is lost, and each says why it cannot be chosen.
  await station.line.pull();
  await expect(menu.getByRole("menuitemcheckbox", { name: "GPS" })).toBeDisabled();
  expect(await places()).toEqual(before);
});
