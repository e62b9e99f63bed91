import { writeFile } from "node:fs/promises";
import { type Page, test } from "@playwright/test";
import { openTab } from "../support/tabs.js";

/** The gateway's address, the flight of two hours that it has, and where the figures go. */
const URL = process.env.BENCH_URL ?? "";
const FLIGHT = process.env.BENCH_FLIGHT ?? "";
const RESULTS = process.env.BENCH_RESULTS ?? "";

const MIDDLE_S = 3600;
const OPENINGS = 5;
const DRAGS = 40;
/** What the page still changes so long after the bar was let go has nothing to do with it. */
const QUIET_MS = 450;
const ZOOMS = 20;
const FRAMES_MS = 10_000;
/** Tabs whose instruments are watched, the fullest first. */
const TABS = ["Datos de vuelo", "Standard Six"];

declare global {
  interface Window {
    /** When the bar was let go, and when something of the open tab last changed. */
    past: { let_go_ms: number; changed_ms: number; drawn_ms: number };
  }
}

test("the page in the past of two hours: the bar, a hundred times real time, plots", async ({ page }) => {
  if (URL === "") throw new Error("`make bench` starts this and says where the gateway is");
  await page.addInitScript(listen);
  const opened_s: number[] = [];
  for (let opening = 0; opening < OPENINGS; opening += 1) opened_s.push(await open(page));
  const drags: Record<string, number[]> = {};
  const fast: Record<string, { frames_per_s: number; rate: number }> = {};
  for (const name of TABS) {
    await openTab(page, name);
    await page.waitForTimeout(1500);
    drags[name] = [];
    for (let drag = 0; drag < DRAGS; drag += 1) drags[name].push(await letGo(page));
    fast[name] = await atHundredfold(page);
  }
  await openTab(page, "Gráficas");
  await page.waitForTimeout(2000);
  const drawn: number[] = [];
  const layouts = page.getByRole("combobox", { name: "Disposición" });
  for (const layout of ["Lazo de cabeceo", "Velocidad y altitud", "Rumbo", "Lazo de alabeo"]) {
    drawn.push(await drawnAfter(page, async () => void (await layouts.selectOption({ label: layout }))));
  }
  const zooms: number[] = [];
  for (let zoom = 0; zoom < ZOOMS; zoom += 1) {
    // Five times in, five times to the side, and out again.
    const name = ["Acercar", "Después", "Alejar", "Antes"][Math.floor(zoom / 5) % 4] ?? "";
    zooms.push(await drawnAfter(page, () => page.getByRole("button", { name, exact: true }).click()));
  }
  await writeFile(RESULTS, JSON.stringify({ opened_s, drags, fast, drawn, zooms }));
});

/** Seconds from asking for the page until an instrument shows the flight, looked for at each animation frame. */
async function open(page: Page): Promise<number> {
  await page.goto("about:blank");
  const began_ms = Date.now();
  await page.goto(`${URL}/?flight=${FLIGHT}&at=${MIDDLE_S}`, { waitUntil: "commit" });
  await page.waitForFunction(() => document.querySelector('[role="tabpanel"] [data-state="live"]') !== null);
  return (Date.now() - began_ms) / 1000;
}

/** In the page, before anything of it: when the bar is let go, when the open tab changes, when a plot is drawn. */
function listen(): void {
  window.past = { let_go_ms: 0, changed_ms: 0, drawn_ms: 0 };
  document.addEventListener("pointerup", () => (window.past.let_go_ms = performance.now()), true);
  const observer = new MutationObserver((changes) => {
    const isShown = changes.some(({ target }) => {
      const element = target instanceof Element ? target : target.parentElement;
      return element?.closest('[role="tabpanel"]') != null;
    });
    if (isShown) window.past.changed_ms = performance.now();
  });
  document.addEventListener("DOMContentLoaded", () =>
    observer.observe(document.body, { subtree: true, childList: true, attributes: true, characterData: true }),
  );
  const stroke = CanvasRenderingContext2D.prototype.stroke;
  CanvasRenderingContext2D.prototype.stroke = function (this: CanvasRenderingContext2D, ...path: unknown[]): void {
    Reflect.apply(stroke, this, path);
    if (this.canvas instanceof HTMLCanvasElement && this.canvas.closest(".plots-chart") !== null) {
      window.past.drawn_ms = performance.now();
    }
  };
}

/** Drag the bar to some moment, and let it go: milliseconds until the last instrument shows that moment. */
async function letGo(page: Page): Promise<number> {
  const box = await page.getByRole("slider", { name: "Momento del vuelo" }).boundingBox();
  if (box === null) throw new Error("the bar is not there");
  const at = (share: number) => box.x + box.width * share;
  const y = box.y + box.height / 2;
  const [from, to] = [0.05 + 0.9 * Math.random(), 0.05 + 0.9 * Math.random()];
  await page.mouse.move(at(from), y);
  await page.mouse.down();
  for (let step = 1; step <= 6; step += 1) {
    await page.mouse.move(at(from + ((to - from) * step) / 6), y);
    await page.waitForTimeout(16);
  }
  await page.mouse.up();
  await page.waitForTimeout(QUIET_MS);
  return await page.evaluate(() => Math.max(0, window.past.changed_ms - window.past.let_go_ms));
}

/** Frames of the page each second while the flight runs a hundred times as fast as it was flown, and how fast it runs. */
async function atHundredfold(page: Page): Promise<{ frames_per_s: number; rate: number }> {
  await page.getByRole("combobox", { name: "Velocidad de reproducción" }).selectOption("100");
  const bar = page.getByRole("slider", { name: "Momento del vuelo" });
  await bar.focus();
  await page.keyboard.press("Home");
  await page.getByRole("button", { name: "Reproducir", exact: true }).click();
  const before = Number(await bar.getAttribute("aria-valuenow"));
  const frames_per_s = await page.evaluate(
    (duration_ms) =>
      new Promise<number>((resolve) => {
        let frames = 0;
        const started = performance.now();
        const count = (now: number) => {
          frames += 1;
          if (now - started < duration_ms) requestAnimationFrame(count);
          else resolve((frames * 1000) / (now - started));
        };
        requestAnimationFrame(count);
      }),
    FRAMES_MS,
  );
  const flown_s = Number(await bar.getAttribute("aria-valuenow")) - before;
  await page.getByRole("button", { name: "Pausa", exact: true }).click();
  await page.waitForTimeout(500);
  return { frames_per_s, rate: (flown_s * 1000) / FRAMES_MS };
}

/** Milliseconds from a wish until the last line of a plot is drawn. */
async function drawnAfter(page: Page, wish: () => Promise<unknown>): Promise<number> {
  const begun = page.evaluate(
    () =>
      new Promise<number>((resolve) => {
        const heard = () => resolve(performance.now());
        document.addEventListener("click", heard, { capture: true, once: true });
        document.addEventListener("change", heard, { capture: true, once: true });
      }),
  );
  await wish();
  const begun_ms = await begun;
  await page.waitForTimeout(QUIET_MS + 300);
  return await page.evaluate((from_ms) => window.past.drawn_ms - from_ms, begun_ms);
}
