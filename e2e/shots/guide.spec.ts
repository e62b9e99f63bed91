import type { Page } from "@playwright/test";
import { expect, open, test } from "../support/fixtures.js";
import { ROOT } from "../support/processes.js";
import { keepWebp, settled } from "./picture.js";

/** Pictures of the guide by name, and the tab of which each is, in both languages. */
const PICTURES = {
  flight: { es: "Datos de vuelo", en: "Flight data" },
  setup: { es: "Setup", en: "Setup" },
  hil: { es: "HIL", en: "HIL" },
  six: { es: "Standard Six", en: "Standard Six" },
  params: { es: "Autopilot Param", en: "Autopilot Param" },
  alarms: { es: "Alarmas", en: "Alarms" },
} as const;

test("the guide's pictures are taken from the station in flight", async ({ page, flying }) => {
  await open(page, flying);
  await expect(page.getByText("Tienes el control", { exact: true })).toBeVisible();
  await page.getByRole("tab", { name: "Autopilot Param", exact: true }).click();
  await page.getByRole("button", { name: "Load", exact: true }).click();
  await expect(page.getByRole("textbox", { name: "k_elev", exact: true })).not.toHaveValue("");
  for (const language of ["es", "en"] as const) {
    await page
      .getByRole("group", { name: /^(Idioma|Language)$/ })
      .getByText({ es: "Español", en: "English" }[language])
      .click();
    for (const [name, tab] of Object.entries(PICTURES)) {
      await page.getByRole("tab", { name: tab[language], exact: true }).click();
      if (name === "alarms") await raiseAlarm(page, flying.url, language);
      await settled(page);
      await keepWebp(page, `${ROOT}/frontend/public/guide/${language}/${name}.webp`);
    }
  }
});

/** A battery that is low by the threshold alone: the alarm is the station's own. */
async function raiseAlarm(page: Page, url: string, language: "es" | "en"): Promise<void> {
  const limits = page.getByRole("region", { name: { es: "Umbrales", en: "Thresholds" }[language] });
  const limit = limits.getByRole("textbox", { name: { es: /Batería/, en: /Battery/ }[language] });
  await limit.fill("60");
  await limit.press("Enter");
  await expect(page.getByRole("alert")).toContainText({ es: "Batería baja", en: "battery is low" }[language]);
  await expect.poll(async () => (await (await fetch(`${url}/api/v1/alarms`)).json()).active.length).toBeGreaterThan(0);
}
