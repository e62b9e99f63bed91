import { expect, open, test } from "../support/fixtures.js";
import { openTab } from "../support/tabs.js";
import { ANY_STATION } from "../support/there.js";

test("what only the board knows is seen with its units and drawn", { tag: ANY_STATION }, async ({ page, flying }) => {
  await open(page, flying);
  await openTab(page, "Mensajes");
  await page.getByRole("button", { name: "line_law", exact: true }).click();
  const row = page.getByRole("row").filter({ has: page.getByRole("button", { name: "line_law", exact: true }) });
  await expect(row).toHaveAttribute("data-state", "live");
  await page.getByRole("button", { name: "Graficar ground_speed_kt" }).click();
  const plot = page.getByRole("region", { name: "Gráfica" });
  await expect(plot).toContainText("line_law.ground_speed_kt");
  await expect(plot).toContainText("kt");
  expect((await flying.sample("wind")).values).toHaveProperty("speed_kt");
});
