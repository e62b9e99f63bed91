import { attitude, expect, open, test } from "../support/fixtures.js";
import { openTab } from "../support/tabs.js";
import { ANY_STATION } from "../support/there.js";

test("a visitor sees the aircraft fly and bank, and the waypoint number advance", { tag: ANY_STATION }, async ({
  page,
  flying,
}) => {
  await open(page, flying);
  await expect(attitude(page)).toHaveAttribute("data-state", "live");
  await expect(page.getByText("Tienes el control", { exact: true })).toBeVisible();

  await openTab(page, "HIL");
  const fms = page.getByRole("region", { name: "Parámetros del Flight Management System" });
  const waypoint = fms.locator("dl > *", { hasText: "Waypoint" });
  const shown = async () => Number(/\d+/.exec((await waypoint.textContent()) ?? "")?.[0]);
  // The third waypoint lies behind the aircraft: on the way to it the autopilot has to bank. By now it may have flown to
  // the first by itself.
  let number = -1;
  while (number < 3) {
    await expect.poll(shown).toBeGreaterThan(number);
    number = await shown();
    await fms.getByRole("button", { name: "Next" }).click();
    await expect.poll(shown).not.toBe(number);
    number = await shown();
  }
  await expect
    .poll(async () => Math.abs(Number(await attitude(page).getAttribute("data-roll-deg"))))
    .toBeGreaterThan(15);
  await expect.poll(async () => await flying.value("ahrs", "roll_deg"), "the turn ends").toBeLessThan(5);
});

test("the page's numbers are the gateway's, in sign and size", { tag: ANY_STATION }, async ({ page, flying }) => {
  await open(page, flying);
  await expect
    .poll(async () => {
      const shown = Number(await attitude(page).getAttribute("data-pitch-deg"));
      return Math.abs(shown - (await flying.value("ahrs", "pitch_deg")));
    })
    .toBeLessThan(1.5);
  const latitude = page.getByRole("tabpanel", { name: "Fast GPS" }).locator("dl > *", { hasText: "Latitud" });
  await expect(latitude).toContainText(/27\.9\d{5}/);
});

const SIZES = [
  { width: 1366, height: 768 },
  { width: 768, height: 1024 },
  { width: 390, height: 844 },
  { width: 844, height: 390 },
];

for (const viewport of SIZES) {
  test(`a first visitor sees at once what flies and where to, and sends it on (${viewport.width} × ${viewport.height})`, {
    tag: ANY_STATION,
  }, async ({ browser, flying }) => {
    const context = await browser.newContext({ viewport, locale: "es-ES" });
    const page = await context.newPage();
    await page.goto(flying.url, { waitUntil: "domcontentloaded" });
    const sentence = page.locator(".fly-sentence");
    await expect(sentence).toContainText(/^Vuelo simulado: ruta Gando, con piloto automático, hacia el waypoint \d/);
    for (const name of ["Velocidad", "Altitud barométrica", "Indicador de actitud", "Indicador de rumbo"]) {
      await expect(page.getByRole("img", { name, exact: true })).toHaveAttribute("data-state", "live");
    }
    const modes = page.getByRole("button", { name: /^Modos;/ });
    for (const mode of ["Fuente", "Joystick", "AP", "On"]) await expect(modes).toContainText(mode);
    const flownTo = async () => Number(/waypoint (\d+)/.exec((await sentence.textContent()) ?? "")?.[1]);
    const before = await flownTo();
    await page.getByRole("button", { name: "Next", exact: true }).click();
    await expect.poll(flownTo).not.toBe(before);
    const scrolled = await page.evaluate(() =>
      [...document.querySelectorAll(".app-tabs > .ui-tabs-panel, .fly-display, .fly")]
        .filter((part) => part.scrollHeight > part.clientHeight + 1 || part.scrollWidth > part.clientWidth + 1)
        .map(({ className }) => className),
    );
    expect(scrolled, "nothing on it scrolls").toEqual([]);
  });
}
