import { expect, open, test } from "../support/fixtures.js";

test("one operator has control at a time: the second page watches until the first lets go", async ({
  page,
  context,
  flying,
}) => {
  await open(page, flying);
  await expect(page.getByText("Tienes el control", { exact: true })).toBeVisible();

  const second = await context.newPage();
  await open(second, flying);
  const on = second.getByRole("group", { name: "Autopilot" }).getByRole("radio", { name: "On" });
  await expect(on).toBeDisabled();
  await expect(second.getByText("Tienes el control", { exact: true })).toHaveCount(0);

  // In the narrowest window with menus nothing of the first row is cut, also while another has control.
  await second.setViewportSize({ width: 1024, height: 768 });
  const asking = second.getByRole("button", { name: "Pedir el control", exact: true });
  for (const shown of [asking, ...(await second.getByRole("group", { name: "Idioma" }).locator("label").all())]) {
    await expect(shown).toBeInViewport({ ratio: 1 });
  }

  await page.getByRole("button", { name: "Soltar" }).click();
  await second.getByRole("button", { name: "Tomar el control" }).click();
  await expect(second.getByText("Tienes el control", { exact: true })).toBeVisible();
  await expect(on).toBeEnabled();
  await expect(page.getByRole("group", { name: "Autopilot" }).getByRole("radio", { name: "On" })).toBeDisabled();

  await second.close();
  // A lost operator's control goes to whoever has watched longest, after some seconds for a page that is only reloaded.
  await expect(page.getByText("Tienes el control", { exact: true })).toBeVisible();
});
