import type { Page } from "@playwright/test";
import { expect, open, test } from "../support/fixtures.js";
import { ROOT, until } from "../support/processes.js";
import type { Station } from "../support/station.js";
import { openTab } from "../support/tabs.js";
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
  await openTab(page, "Autopilot Param");
  await page.getByRole("button", { name: "Load", exact: true }).click();
  await expect(page.getByRole("textbox", { name: "k_elev", exact: true })).not.toHaveValue("");
  for (const language of ["es", "en"] as const) {
    await page
      .getByRole("group", { name: /^(Idioma|Language)$/ })
      .getByText({ es: "Español", en: "English" }[language])
      .click();
    for (const [name, tab] of Object.entries(PICTURES)) {
      await openTab(page, tab[language]);
      if (name === "alarms") await raiseAlarm(page, flying.url, language);
      await settled(page);
      await keepWebp(page, `${ROOT}/frontend/public/guide/${language}/${name}.webp`);
    }
  }
  await landed(page, flying);
});

/** The chapters about flights that are over: the past, the library, plots and the report. */
async function landed(page: Page, station: Station): Promise<void> {
  await openTab(page, "Setup");
  for (const line of ["X-Plane", "Autopilot link"]) {
    await page.getByRole("region", { name: line, exact: true }).getByRole("button", { name: "Close" }).click();
  }
  const { id, duration_s } = await until("the flight's preparation", async () =>
    (await station.flights()).find(({ state }) => state === "indexed"),
  );
  for (const language of ["en", "es"] as const) {
    const words = {
      es: { language: "Español", plots: "Gráficas", flights: "Vuelos", list: "Vuelos grabados", report: "Informe" },
      en: { language: "English", plots: "Plots", flights: "Flights", list: "Recorded flights", report: "Report" },
    }[language];
    const keep = async (name: string): Promise<void> => {
      await settled(page);
      await keepWebp(page, `${ROOT}/frontend/public/guide/${language}/${name}.webp`);
    };
    await page
      .getByRole("group", { name: /^(Idioma|Language)$/ })
      .getByText(words.language)
      .click();
    await page.goto(`${station.url}/?flight=${id}&at=${Math.round(0.7 * (duration_s ?? 0))}`);
    await openTab(page, "HIL Standard Six");
    await expect(page.getByRole("tabpanel").locator("[data-state=live]").first()).toBeVisible();
    await keep("past");
    await openTab(page, words.plots);
    await expect(page.getByRole("table").first().getByRole("row").nth(1)).toContainText(/\d\.\d/);
    await keep("plots");
    await page.keyboard.press("Escape");
    await openTab(page, words.flights);
    await page.getByRole("list", { name: words.list }).getByRole("button").first().click();
    await keep("flights");
    await page.getByRole("button", { name: words.report, exact: true }).last().click();
    await expect(page.getByRole("article").first()).toBeVisible();
    await keep("report");
    await page.goto(station.url);
  }
}

/** A battery that is low by the threshold alone: the alarm is the station's own. */
async function raiseAlarm(page: Page, url: string, language: "es" | "en"): Promise<void> {
  const limits = page.getByRole("region", { name: { es: "Umbrales", en: "Thresholds" }[language] });
  const limit = limits.getByRole("textbox", { name: { es: /Batería/, en: /Battery/ }[language] });
  await limit.fill("60");
  await limit.press("Enter");
  await expect(page.getByRole("alert")).toContainText({ es: "Batería baja", en: "battery is low" }[language]);
  await expect.poll(async () => (await (await fetch(`${url}/api/v1/alarms`)).json()).active.length).toBeGreaterThan(0);
}
