import type { Page } from "@playwright/test";
import { attitude, expect, open, test } from "../support/fixtures.js";
import { openTab } from "../support/tabs.js";
import { ANY_STATION } from "../support/there.js";

declare global {
  interface Window {
    /** Pictures of the globe so far. */
    drawn: number;
  }
}

async function openMap(page: Page): Promise<void> {
  await openTab(page, "Mapa 3D");
  await expect(page.locator(".map-host .globe-picture")).toBeVisible();
}

/** A camera's angle as the panel tells it. */
async function eye(page: Page, name: string): Promise<number> {
  const row = page.locator(".map-camera .ui-readout", { has: page.getByText(name, { exact: true }) });
  return Number((await row.locator(".ui-readout-number").innerText()).replace(",", "."));
}

/** What the attitude indicator shows at this moment. */
async function indicated(page: Page): Promise<{ pitch_deg: number; roll_deg: number }> {
  const { pitchDeg, rollDeg } = await attitude(page).evaluate((element) => ({
    ...(element as HTMLElement).dataset,
  }));
  return { pitch_deg: Number(pitchDeg), roll_deg: Number(rollDeg) };
}

test("the page without the map loads nothing of the globe", { tag: ANY_STATION }, async ({ page, flying }) => {
  const asked: string[] = [];
  page.on("request", (request) => asked.push(new URL(request.url()).pathname));
  await open(page, flying);
  // The parts that are loaded ahead are there when the last of them is.
  await expect.poll(() => asked.some((path) => path.includes("GuideContent"))).toBe(true);
  expect(asked.filter((path) => /cesium|globe-engine|coastline/i.test(path))).toEqual([]);
});

test("the globe shows the flight from behind and from the cockpit, and asks nobody but the gateway", {
  tag: ANY_STATION,
}, async ({ page, flying }) => {
  await open(page, flying);
  await openMap(page);
  const panel = page.locator(".map-camera");
  await expect(panel.getByText("HIL: en vivo")).toBeVisible();

  // Behind and above the aircraft, until it is turned.
  await expect.poll(() => eye(page, "Cabeceo")).toBeCloseTo(-14, 0);
  await page.locator(".map-host").focus();
  await page.keyboard.press("ArrowDown");
  await page.keyboard.press("ArrowDown");
  await expect.poll(() => eye(page, "Cabeceo")).toBeLessThan(-20);

  // The cockpit's horizon is the attitude indicator's: its aircraft is the simulator's too.
  await panel.getByText("Cabina", { exact: true }).click();
  await expect(async () => {
    const before = await indicated(page);
    const [pitch_deg, roll_deg] = [await eye(page, "Cabeceo"), await eye(page, "Alabeo")];
    const after = await indicated(page);
    // Both move while they are read, and the globe is drawn a few times a second.
    const room_deg = 3 + Math.abs(after.roll_deg - before.roll_deg) + Math.abs(after.pitch_deg - before.pitch_deg);
    expect(Math.abs(pitch_deg - after.pitch_deg)).toBeLessThan(room_deg);
    expect(Math.abs(roll_deg - after.roll_deg)).toBeLessThan(room_deg);
  }).toPass();

  // A key goes round the cameras, wherever the focus is.
  await page.keyboard.press("v");
  await expect(panel.getByRole("radio", { name: "Seguir" })).toBeChecked();
});

/** Words of the station that a resting globe must hear without being drawn; it speaks twice a second. */
const WORDS = 6;

test("a globe on which nothing moves is not drawn, whatever the station says", async ({ page, station }) => {
  await page.addInitScript(() => {
    window.drawn = 0;
    new PerformanceObserver((list) => {
      window.drawn += list.getEntriesByName("globe.script").length;
    }).observe({ type: "measure" });
  });
  let words = 0;
  page.on("websocket", (socket) =>
    socket.on("framereceived", ({ payload }) => {
      if (payload.includes('"type":"status"')) words += 1;
    }),
  );
  await open(page, station);
  await openMap(page);
  await page.locator(".map-camera").getByText("Libre", { exact: true }).click();
  await expect.poll(async () => [await eye(page, "Dibujado"), await eye(page, "Cabeceo")]).toEqual([0, -40]);
  // The ground's pictures may still come; then it rests for as long as the station says nothing new.
  await expect(async () => {
    const [drawn, heard] = [await page.evaluate(() => window.drawn), words];
    expect(drawn).toBeGreaterThan(0);
    await expect.poll(() => words).toBeGreaterThanOrEqual(heard + WORDS);
    expect(await page.evaluate(() => window.drawn)).toBe(drawn);
  }).toPass();
});
