import type { Locator, Page } from "@playwright/test";
import { expect, open, test } from "../support/fixtures.js";
import { colourAt } from "../support/pixels.js";
import { until } from "../support/processes.js";
import { LiveRecord } from "../support/record.js";
import type { Station } from "../support/station.js";
import { openTab } from "../support/tabs.js";

/** The page in either language. */
const WORDS = {
  es: {
    past: "PASADO",
    present: "El presente",
    bar: "Momento del vuelo",
    attitude: "Indicador de actitud",
    latitude: "Latitud",
    blocked: "Estás viendo el pasado",
    now: "Volver a ahora",
    play: "Reproducir",
    next: "Suceso siguiente",
  },
  en: {
    past: "PAST",
    present: "The present",
    bar: "Moment of the flight",
    attitude: "Attitude indicator",
    latitude: "Latitude",
    blocked: "You are looking at the past",
    now: "Back to now",
    play: "Play",
    next: "Next event",
  },
} as const;
type Language = keyof typeof WORDS;

/** Latitude that the aircraft flies through in about a second: the GPS does not measure more often by much. */
const NEAR_DEG = 0.0004;
/** Violet, as nothing else on the page is: blue before red before green. */
const isViolet = ([red = 0, green = 0, blue = 0]: readonly number[]) => blue > red && red > green + 15;

const bar = (page: Page, language: Language): Locator => page.getByRole("slider", { name: WORDS[language].bar });
const strip = (page: Page, language: Language): Locator =>
  page.getByRole("region", { name: WORDS[language].present, exact: true });

/** Latitude as the first tab's GPS panel has it. */
async function latitude(page: Page, language: Language): Promise<number> {
  const shown = page
    .getByRole("tabpanel", { name: "Fast GPS" })
    .locator("dl > *", { hasText: WORDS[language].latitude });
  return Number(/-?\d+\.\d{5,}/.exec((await shown.textContent()) ?? "")?.[0]);
}

/** The moment that the page's address names, Unix seconds. */
async function momentOf(page: Page, station: Station): Promise<number> {
  const { searchParams } = new URL(page.url());
  const flight = searchParams.get("flight") ?? "none";
  return (await station.flight(flight)).started_s + Number(searchParams.get("at"));
}

/** Whether this is what the aircraft did at the moment that the page says it shows. */
async function showsItsMoment(page: Page, station: Station, record: LiveRecord, language: Language): Promise<void> {
  await expect(async () => {
    const recorded = record.at(await momentOf(page, station), "gps", "latitude_deg");
    expect(Math.abs((await latitude(page, language)) - recorded)).toBeLessThan(NEAR_DEG);
  }).toPass();
}

/** Frame, words and title, and nothing that can be commanded. */
async function looksPast(page: Page, language: Language): Promise<void> {
  const { past, blocked } = WORDS[language];
  await expect(page.getByRole("status").filter({ hasText: new RegExp(`^${past}$`) })).toBeVisible();
  await expect(page).toHaveTitle(new RegExp(`^(\\(\\d+\\) )?${past} \\d{4}-\\d\\d-\\d\\d \\d\\d:\\d\\d:\\d\\d`));
  const { width, height } = page.viewportSize() ?? { width: 0, height: 0 };
  for (const [x, y] of [
    [2, height / 2],
    [width - 3, height / 2],
    [width / 2, 2],
    [width / 2, height - 3],
  ] as const) {
    const colour = await colourAt(page, x, y);
    expect(isViolet(colour), `the frame at ${x}, ${y} is ${colour}`).toBe(true);
  }
  const readAll = page.getByRole("button", { name: "Read All", exact: true });
  await expect(readAll).toBeDisabled();
  await expect(readAll).toHaveAccessibleDescription(new RegExp(blocked));
}

/** The present in small is live and is the gateway's. */
async function showsThePresent(page: Page, station: Station, language: Language): Promise<void> {
  const horizon = strip(page, language).getByRole("img", { name: WORDS[language].attitude });
  await expect(horizon).toHaveAttribute("data-state", "live");
  await expect
    .poll(async () => {
      const shown = Number(await horizon.getAttribute("data-pitch-deg"));
      return Math.abs(shown - (await station.value("ahrs", "pitch_deg")));
    })
    .toBeLessThan(1.5);
  const first = await horizon.getAttribute("data-pitch-deg");
  await expect.poll(async () => await horizon.getAttribute("data-pitch-deg")).not.toBe(first);
}

/** Everything is of the present again. */
async function isNow(page: Page, station: Station, language: Language): Promise<void> {
  await expect(strip(page, language)).toHaveCount(0);
  await expect(page.getByRole("status").filter({ hasText: new RegExp(`^${WORDS[language].past}$`) })).toHaveCount(0);
  await expect(page).not.toHaveTitle(new RegExp(WORDS[language].past));
  expect(new URL(page.url()).search).toBe("");
  await expect(page.getByRole("button", { name: "Read All", exact: true })).toBeEnabled();
  await expect
    .poll(async () => Math.abs((await latitude(page, language)) - (await station.value("gps", "latitude_deg"))))
    .toBeLessThan(NEAR_DEG);
}

/** The place on the bar of a part of the time flown so far; the bar of a young flight has room for its first 30 seconds. */
async function placeOn(page: Page, language: Language, part: number): Promise<{ x: number; y: number }> {
  const box = await bar(page, language).boundingBox();
  if (box === null) throw new Error("the bar is not there");
  const edge_s = Number(await bar(page, language).getAttribute("aria-valuemax"));
  return { x: box.x + (box.width * part * edge_s) / Math.max(30, edge_s), y: box.y + box.height / 2 };
}

/** Wait until so much of the flight lies behind the page. */
async function flown(page: Page, language: Language, seconds: number): Promise<void> {
  await expect
    .poll(async () => Number(await bar(page, language).getAttribute("aria-valuemax")))
    .toBeGreaterThan(seconds);
}

test("a pilot looks ten seconds back in flight, sees the present beside it, and opens the flight after landing", {
  // A question about the running flight that arrives after its end is refused.
  tag: "@refused",
}, async ({ page, flying }) => {
  const record = new LiveRecord(page);
  await open(page, flying);
  await expect(page.getByText("Tienes el control", { exact: true })).toBeVisible();

  await test.step("a mark", async () => {
    await page.keyboard.press("Shift+M");
    const dialog = page.getByRole("dialog", { name: "Marca ahora" });
    await dialog.getByRole("textbox", { name: "Qué ha pasado" }).fill("viraje");
    await page.keyboard.press("Enter");
    await expect(dialog).toHaveCount(0);
  });

  await test.step("ten seconds back by the keyboard", async () => {
    await flown(page, "es", 13);
    await bar(page, "es").focus();
    await page.keyboard.press("Control+ArrowLeft");
    await looksPast(page, "es");
    await showsItsMoment(page, flying, record, "es");
    expect(Math.abs((await latitude(page, "es")) - (await flying.value("gps", "latitude_deg")))).toBeGreaterThan(
      3 * NEAR_DEG,
    );
    await showsThePresent(page, flying, "es");
    await page.keyboard.press("Shift+A");
    await page.keyboard.press("Enter");
  });

  await test.step("to another moment by dragging", async () => {
    const [from, to] = [await placeOn(page, "es", 0.9), await placeOn(page, "es", 0.7)];
    const before = await bar(page, "es").getAttribute("aria-valuetext");
    await page.mouse.move(from.x, from.y);
    await page.mouse.down();
    await page.mouse.move(to.x, to.y, { steps: 5 });
    await page.mouse.up();
    await expect(bar(page, "es")).not.toHaveAttribute("aria-valuetext", before ?? "");
    await showsItsMoment(page, flying, record, "es");
  });

  await test.step("Esc is now", async () => {
    await page.keyboard.press("Escape");
    await isNow(page, flying, "es");
    expect(await flying.value("heartbeat", "autopilot_hil"), "the keys of the past commanded nothing").toBe(true);
  });

  await test.step("an alarm: the board's line is pulled, and plugged in again", async () => {
    const alarms = page.getByRole("region", { name: "Alarmas" });
    await flying.line.pull();
    await expect(alarms.getByRole("alert")).toContainText("Se ha perdido el latido de la placa");
    await flying.line.plugIn();
    await expect(alarms.getByRole("alert")).not.toContainText("latido");
  });

  await test.step("both lines closed", async () => {
    await openTab(page, "Setup");
    for (const line of ["XPlane", "Comunicación con el Piloto Automático"]) {
      await page.getByRole("region", { name: line, exact: true }).getByRole("button", { name: "Close" }).click();
    }
    await expect.poll(async () => (await flying.status()).recording.active).toBe(false);
    await openTab(page, "Datos de vuelo");
  });
  const { id, started_s } = await until("the flight's preparation", async () =>
    (await flying.flights()).find(({ state }) => state === "indexed"),
  );

  await test.step("by its address", async () => {
    await page.goto(`${flying.url}/?flight=${id}&at=5`, { waitUntil: "domcontentloaded" });
    await looksPast(page, "es");
    await expect
      .poll(async () => Math.abs((await latitude(page, "es")) - record.at(started_s + 5, "gps", "latitude_deg")))
      .toBeLessThan(NEAR_DEG);
  });

  await test.step("to the mark, from the list of what happened", async () => {
    await openTab(page, "Vuelos");
    await page
      .getByRole("list", { name: "Vuelos grabados" })
      .getByRole("listitem")
      .first()
      .getByRole("button")
      .first()
      .click();
    await page
      .getByRole("list", { name: "Qué pasó" })
      .getByRole("button", { name: /Marca: viraje/ })
      .click();
    await expect.poll(() => Number(new URL(page.url()).searchParams.get("at"))).not.toBe(5);
    await openTab(page, "Datos de vuelo");
    await showsItsMoment(page, flying, record, "es");
  });

  await test.step("to the alarm, at which the line was lost", async () => {
    const alarms = page.getByRole("list", { name: "Qué pasó" }).getByRole("button", { name: /latido/ });
    let next = 0;
    // A busy machine may have kept a heartbeat back earlier in the flight, with the line open: that is another alarm.
    await expect(async () => {
      await openTab(page, "Vuelos");
      await alarms.nth(next++ % (await alarms.count())).click();
      await openTab(page, "Datos de vuelo");
      await expect(page.getByRole("contentinfo")).toContainText("perdido", { timeout: 20_000 });
    }).toPass();
  });

  await test.step("its signals", async () => {
    await openTab(page, "Gráficas");
    const figures = page.getByRole("region", { name: "Gráfica 1", exact: true }).getByRole("table");
    await expect(figures.getByRole("row").nth(1)).toContainText(/-?\d+\.\d/);
  });

  await test.step("beside another flight, which came from another machine", async () => {
    await openTab(page, "Vuelos");
    const stretch = await page.request.get(`${flying.url}/api/v1/flights/${id}/export?format=mcap&from_s=0&to_s=12`);
    const chooser = page.waitForEvent("filechooser");
    await page.getByRole("button", { name: "Importar…", exact: true }).click();
    await (await chooser).setFiles({ name: "ayer.mcap", mimeType: "application/mcap", buffer: await stretch.body() });
    await expect(page.getByText("ayer.mcap ya está en la biblioteca.")).toBeVisible();
    const flights = page.getByRole("list", { name: "Vuelos grabados" });
    await expect(flights.getByRole("listitem").filter({ hasText: "ayer" })).toBeVisible();
    await until("its preparation", async () =>
      (await flying.flights()).every(({ state }) => state === "indexed") ? true : undefined,
    );
    const choices = flights.getByRole("checkbox", { name: /^Comparar / });
    // The page hears of the preparation a moment after the station answers for it.
    await expect(choices).toHaveCount(2);
    for (const choice of await choices.all()) await choice.check();
    await page.getByRole("button", { name: "Gráficas de ambos", exact: true }).click();
    const figures = page.getByRole("region", { name: "Gráfica 1", exact: true }).getByRole("table");
    // The one that was chosen last is laid over: its figures stand below, after its name.
    const over = figures.getByRole("row", { name: /(ayer|\d{4}-\d\d-\d\d \d\d:\d\d:\d\d) · / });
    await expect(over.first()).toContainText(/-?\d+\.\d/);
    await openTab(page, "Vuelos");
    await flights.getByRole("listitem").filter({ hasNotText: "ayer" }).getByRole("button").first().click();
  });

  await test.step("handed over as a file", async () => {
    await page.getByRole("button", { name: "Exportar…", exact: true }).click();
    const dialog = page.getByRole("dialog", { name: /^Exportar/ });
    await dialog.getByRole("radio", { name: /^GPX/ }).check();
    await dialog.getByRole("button", { name: "Exportar", exact: true }).click();
    const link = page.getByRole("link", { name: /^Descargar .*\.gpx/ });
    const file = page.waitForEvent("download");
    await link.click();
    expect((await file).suggestedFilename()).toMatch(/\.gpx$/);
  });

  await test.step("its report", async () => {
    await page
      .getByRole("region", { name: /^Vuelo / })
      .getByRole("button", { name: "Informe", exact: true })
      .click();
    const report = page.getByRole("article").filter({ has: page.getByRole("heading", { name: "Informe de vuelo" }) });
    await expect(report).toContainText("viraje");
    await expect(report).toContainText("latido");
    await page.getByRole("combobox", { name: "Comparar con", exact: true }).selectOption({ label: "ayer" });
    await expect(report.getByRole("columnheader", { name: /^Vuelo \d{4}-/ }).first()).toBeVisible();
    await page.getByRole("button", { name: "Cerrar informe", exact: true }).click();
    await expect(report).toHaveCount(0);
  });

  await test.step("Esc is now, also on the ground", async () => {
    await page.keyboard.press("Escape");
    await expect(strip(page, "es")).toHaveCount(0);
    expect(new URL(page.url()).search).toBe("");
  });
});

test.describe("on a tablet", () => {
  test.use({ viewport: { width: 1024, height: 768 }, hasTouch: true });

  test("fingers go back, play and return to now, in English", async ({ page, flying }) => {
    const record = new LiveRecord(page);
    await open(page, flying);
    await page.getByRole("button", { name: "Menú", exact: true }).tap();
    await page.getByRole("group", { name: "Idioma" }).getByText("English").tap();
    await page.getByRole("group", { name: "Time of the flight" }).getByText("Shown", { exact: true }).tap();
    await page.keyboard.press("Escape");
    await flown(page, "en", 8);
    const { x, y } = await placeOn(page, "en", 0.6);
    await page.touchscreen.tap(x, y);
    await looksPast(page, "en");
    await showsItsMoment(page, flying, record, "en");
    await showsThePresent(page, flying, "en");

    // All of it is in the window and large enough for a finger.
    for (const name of [WORDS.en.play, WORDS.en.next, WORDS.en.now]) {
      const control = page.getByRole("button", { name, exact: true });
      await expect(control).toBeInViewport({ ratio: 1 });
      const size = await control.boundingBox();
      expect(Math.min(size?.width ?? 0, size?.height ?? 0), name).toBeGreaterThanOrEqual(44);
    }
    const before = Number(await bar(page, "en").getAttribute("aria-valuenow"));
    await page.getByRole("button", { name: WORDS.en.play, exact: true }).tap();
    await expect
      .poll(async () => Number(await bar(page, "en").getAttribute("aria-valuenow")))
      .toBeGreaterThan(before + 1);
    await page.getByRole("button", { name: WORDS.en.now, exact: true }).tap();
    await isNow(page, flying, "en");
  });
});
