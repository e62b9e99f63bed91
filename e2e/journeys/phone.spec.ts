import AxeBuilder from "@axe-core/playwright";
import type { Page } from "@playwright/test";
import { expect, open, test } from "../support/fixtures.js";
import { openTab } from "../support/tabs.js";
import { SIZES, sizeName, Walk } from "../support/walk.js";

const PHONE = { width: 360, height: 640 };
const SIDEWAYS = { width: 915, height: 412 };
/** `EVERY_TOUCH_SIZE=1` takes all windows where fingers are used, and a picture of each step to be looked at. */
const everySize = process.env.EVERY_TOUCH_SIZE !== undefined;
const TOUCHED = SIZES.filter(({ touch }) => touch === true);
const WINDOWS = everySize ? { es: TOUCHED, en: TOUCHED } : { es: [PHONE], en: [SIDEWAYS] };

/** What a pilot reads and presses, in both languages. */
const WORDS = {
  es: {
    name: "Tu nombre",
    enter: "Entrar",
    mine: "Tienes el control",
    release: "Soltar",
    take: "Tomar el control",
    plans: "Planes de vuelo",
    hilPlan: "Plan HIL",
    read: "Descargar de la placa",
    insert: "Insertar",
    send: "Enviar a la placa",
    startAgain: "Enviar y empezar por el 1",
    goTo: /^Ir a \d+$/,
    gone: /Ir al waypoint: confirmado/,
    proven: /Plan HIL: la placa tiene los \d+ waypoints/,
    alarms: "Alarmas",
    lost: /Se ha perdido el latido de la placa/,
    acknowledge: /^Reconocer que terminó: latido perdido/,
    log: "Abrir el registro de mensajes",
    close: "Cerrar",
    last: "Último mensaje",
    back: "Datos de vuelo",
  },
  en: {
    name: "Your name",
    enter: "Enter",
    mine: "You have control",
    release: "Release",
    take: "Take control",
    plans: "Flight plans",
    hilPlan: "HIL plan",
    read: "Download from board",
    insert: "Insert",
    send: "Send to board",
    startAgain: "Send and start at 1",
    goTo: /^Go to \d+$/,
    gone: /Go to waypoint: confirmed/,
    proven: /HIL plan: the board has the \d+ waypoints/,
    alarms: "Alarms",
    lost: /The board.s heartbeat on .* is lost/,
    acknowledge: /^Acknowledge that it ended: heartbeat lost/,
    log: "Open the log of messages",
    close: "Close",
    last: "Last message",
    back: "Flight data",
  },
} as const;

test.describe("a pilot with nothing but a phone", () => {
  test.use({ trustsThisComputer: false });

  const all = (["es", "en"] as const).flatMap((language) =>
    WINDOWS[language].map((viewport) => ({ language, viewport })),
  );
  for (const { language, viewport } of all) {
    const size = sizeName(viewport);
    test(`joins, takes control, adds a waypoint and flies it, sees and acknowledges an alarm (${language}, ${size})`, async ({
      browser,
      flying,
    }) => {
      const say = WORDS[language];
      const context = await browser.newContext({ viewport, hasTouch: true, isMobile: true, locale: language });
      const seen = async (step: string): Promise<void> => {
        const path = `test-results/touch/${sizeName(viewport)}-${language}-${step}.png`;
        if (everySize) await page.screenshot({ path });
      };
      await context.addInitScript((code) => {
        localStorage.setItem("epf-gcs.settings", JSON.stringify({ language: code }));
      }, language);
      const page = await context.newPage();
      const tap = async (name: string | RegExp) =>
        await page.getByRole("button", { name, exact: typeof name === "string" }).tap();

      await page.goto(`${flying.url}/#key=${await flying.invite("operator")}`, { waitUntil: "domcontentloaded" });
      await page.getByRole("textbox", { name: say.name }).fill("Ana");
      await tap(say.enter);
      const mine = page.getByText(say.mine, { exact: true });
      await expect(mine).toBeVisible();
      await tap(say.release);
      await tap(say.take);
      await expect(mine).toBeVisible();
      await seen("1-control");

      await openTab(page, say.plans);
      await page.getByRole("tab", { name: say.hilPlan, exact: true }).tap();
      await tap(say.read);
      const rows = page.getByRole("tabpanel", { name: say.hilPlan }).getByRole("row");
      await expect.poll(async () => await rows.count(), "the route that the board flies").toBeGreaterThan(3);
      const before = await rows.count();
      await tap(say.insert);
      await expect(rows).toHaveCount(before + 1);
      await seen("2-waypoint");
      // Asked where the board flies on already, or where its plan's stream was late at this moment.
      const startAgain = page.getByRole("button", { name: say.startAgain, exact: true });
      await page.addLocatorHandler(startAgain, async () => await startAgain.tap());
      await tap(say.send);
      const last = page.getByRole("status", { name: say.last });
      await expect(last).toContainText(say.proven);
      await tap(say.goTo);
      await expect(last).toContainText(say.gone);
      await seen("3-flown");

      await flying.line.pull();
      const alarm = page.getByRole("alert").filter({ hasText: say.lost }).first();
      await expect(alarm).toBeInViewport({ ratio: 1 });
      const isCut = await alarm
        .getByText(say.lost)
        .evaluate(({ scrollHeight, clientHeight }) => scrollHeight > clientHeight + 1);
      expect(isCut, "the sentence of the alarm is whole").toBe(false);
      await seen("4-alarm");
      await flying.line.plugIn();
      await page.getByRole("button", { name: say.acknowledge }).tap();
      await expect(page.getByRole("button", { name: say.acknowledge })).toHaveCount(0);

      await tap(say.log);
      await expect(page.getByRole("dialog")).toBeVisible();
      await seen("5-log");
      await page.getByRole("dialog").getByRole("button", { name: say.close, exact: true }).tap();
      await openTab(page, say.back);
      await expect(page.getByRole("tabpanel", { name: say.back })).toBeVisible();
      await seen("6-back");
    });
  }
});

/** Serious for an eye or a hand; the rest of the rules is the barriers' journey. */
async function barriers(page: Page): Promise<string[]> {
  const { violations } = await new AxeBuilder({ page }).setLegacyMode().exclude("[data-base-ui-focus-guard]").analyze();
  return violations.map(({ id, nodes }) => `${id} ${nodes[0]?.html}`);
}

test("nothing is cut, covered or too small for a finger, on a phone and at a zoom of 400 %", async ({
  page,
  flying,
}) => {
  // What has ended stands in the strip until somebody acknowledges it: the fullest that the strip is for long.
  await flying.leaveEndedAlarms({ battery_low_v: 60, altitude_high_ft: 1, airspeed_high_kt: 1, distance_far_m: 1 });
  await open(page, flying);
  await expect(
    page.getByRole("region", { name: "Alarmas" }).getByRole("button", { name: /^\+\d+ terminada/ }),
  ).toBeVisible();
  const walk = await Walk.of(page);
  const faults: string[] = [];
  await walk.resize({ width: 360, height: 640, touch: true });
  faults.push(...(await walk.tabs()), ...(await barriers(page)));
  await walk.resize({ width: 320, height: 256, zoom: 4 });
  faults.push(...(await walk.tabs()));
  expect(faults).toEqual([]);
});
