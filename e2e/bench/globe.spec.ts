import { writeFile } from "node:fs/promises";
import { type CDPSession, expect, type Page, test } from "@playwright/test";
import { openTab } from "../support/tabs.js";
import { browserSeconds } from "./processor.js";

/** The gateway's address, where flights are ordered, where the figures go, and how long each is measured. */
const URL = process.env.BENCH_URL ?? "";
const ORDERS = process.env.BENCH_ORDERS ?? "";
const RESULTS = process.env.BENCH_RESULTS ?? "";
const SECONDS = Number(process.env.BENCH_SECONDS ?? "10");

const SHORT = 1000;
/**
 * Two hours of 50 Hz, and as far into a block of 1,024 points as the short track: every point of the newest block is
 * drawn, so that blocks of different lengths would be compared with it.
 */
const LONG = 351 * 1024 + SHORT;
/** From here on the flight is compared with its end: what is made once has been made. */
const BEGUN = 90_000;
/** Points flown in a second where hours shall pass. */
const HASTE = 12_000;
/** Frames that are drawn before any counts: shaders are compiled in the first. */
const WARMING = 5;
/** Short and long in turn, so often. */
const ROUNDS = 3;
const PATIENCE_MS = 240_000;
const IDLE_MS = 10_000;

type Timing = { name: string; at_ms: number; took_ms: number };
type Rates = { frames_per_s: number; moved_per_s: number };
/** `middle`: the mean of the middle half. */
type Shares = { p50: number; p95: number; middle: number };
type Growing = {
  /** Milliseconds of processor time that the graphics used for each frame, what they did beside it included. */
  graphics_ms: number;
  script: Shares;
  frame: Shares;
  update: Shares;
  take: Shares;
  drawn_per_s: number;
  frames_per_s: number;
  moved_per_s: number;
};

declare global {
  interface Window {
    /** What the page has told of itself, in the order of time. */
    timings: Timing[];
    /** When the map's tab was last clicked. */
    clicked_ms: number;
  }
}

test("the globe with long tracks, growing, at rest, and opened again", async ({ page }) => {
  if (URL === "") throw new Error("`make bench` starts this and says where the gateway is");
  const devtools = await page.context().newCDPSession(page);
  await page.addInitScript(listen);
  const open_s = { first: await openMap(page), second: await openMap(page) };
  await settled(page);
  const idle = { empty: await framesIn(page, IDLE_MS), parked: Number.NaN };

  await camera(page, "Libre");
  const heap = await measureHeap(page, devtools);

  await order("/fly?how=on");
  const free = await compare(page, ROUNDS);
  await camera(page, "Seguir");
  const follow = await compare(page, ROUNDS);

  await order("/fly?how=parked");
  await settled(page);
  idle.parked = await framesIn(page, IDLE_MS);
  await writeFile(RESULTS, JSON.stringify({ open_s, idle, heap, free, follow }));
});

/** In the page, before anything of it: hears what it tells of itself. */
function listen(): void {
  window.timings = [];
  new PerformanceObserver((list) => {
    for (const { name, startTime, duration } of list.getEntries()) {
      window.timings.push({ name, at_ms: startTime, took_ms: duration });
    }
  }).observe({ type: "measure" });
  document.addEventListener(
    "pointerdown",
    () => {
      window.clicked_ms = performance.now();
    },
    true,
  );
}

async function order(path: string): Promise<void> {
  const answer = await fetch(`${ORDERS}${path}`, { method: "POST" });
  if (!answer.ok) throw new Error(`${path}: ${answer.status}`);
}

/** Seconds from the click on the tab to the end of the globe's first frame, of a page that is opened for it. */
async function openMap(page: Page): Promise<number> {
  await page.goto(URL, { waitUntil: "domcontentloaded" });
  await openTab(page, "Planes de vuelo");
  await page.getByRole("tab", { name: "Mapa 3D", exact: true }).click();
  const drawn = await page.waitForFunction(
    () => window.timings.find(({ name, at_ms }) => name === "globe.picture" && at_ms > window.clicked_ms),
    undefined,
    { timeout: PATIENCE_MS },
  );
  const first = (await drawn.jsonValue()) as Timing;
  const clicked_ms = await page.evaluate(() => window.clicked_ms);
  return (first.at_ms + first.took_ms - clicked_ms) / 1000;
}

/** Nothing has been drawn for a while, and nothing is on its way: a frame in which shaders are made takes seconds. */
async function settled(page: Page): Promise<void> {
  await expect
    .poll(async () => (await framesIn(page, 3000)) + Math.max(0, await framesOnTheirWay(page)), {
      timeout: PATIENCE_MS,
    })
    .toBe(0);
}

async function framesOnTheirWay(page: Page): Promise<number> {
  return await page.evaluate(() => {
    const told = (wanted: string) => window.timings.filter(({ name }) => name === wanted).length;
    return told("globe.script") - told("globe.picture");
  });
}

async function framesIn(page: Page, duration_ms: number): Promise<number> {
  return (await timingsIn(page, duration_ms)).filter(({ name }) => name === "globe.script").length;
}

async function timingsIn(page: Page, duration_ms: number): Promise<Timing[]> {
  const begin_ms = await page.evaluate(() => performance.now());
  await page.waitForTimeout(duration_ms);
  return await page.evaluate((from_ms) => window.timings.filter(({ at_ms }) => at_ms >= from_ms), begin_ms);
}

async function camera(page: Page, name: string): Promise<void> {
  await page.getByRole("radio", { name, exact: true }).check({ force: true });
}

/** The page has this many points of the simulator's track, and so many blocks of them as it shall ever have. */
async function hasPoints(page: Page, least: number): Promise<void> {
  const row = page.locator(".map-track-row").last();
  await expect
    .poll(async () => Number((await row.innerText()).match(/(\d[\d.]*) puntos/)?.[1]?.replaceAll(".", "") ?? 0), {
      timeout: PATIENCE_MS,
    })
    .toBeGreaterThanOrEqual(least);
}

/** A short and a long track in turn: what else the machine does meanwhile falls on both. */
async function compare(page: Page, rounds: number): Promise<{ short: Growing; long: Growing }> {
  const found: Record<"short" | "long", Phase[]> = { short: [], long: [] };
  for (let round = 0; round < rounds; round += 1) {
    for (const [length, points] of [
      ["short", SHORT],
      ["long", LONG],
    ] as const) {
      await order(`/put?points=${points}`);
      await hasPoints(page, points);
      // The levels of detail of the blocks that came at once are made, and the ground is there.
      await page.waitForTimeout(2000);
      await page.evaluate(() => {
        window.timings = [];
      });
      await expect.poll(() => framesSoFar(page), { timeout: PATIENCE_MS }).toBeGreaterThan(WARMING);
      found[length].push(await phase(page));
    }
  }
  return { short: summary(found.short), long: summary(found.long) };
}

type Phase = { timings: Timing[]; rates: Rates; graphics_s: number; seconds: number };

async function phase(page: Page): Promise<Phase> {
  const [begun_s, begun_ms] = [browserSeconds().graphics, performance.now()];
  const [timings, rates] = await Promise.all([timingsIn(page, SECONDS * 1000), watchRates(page, SECONDS * 1000)]);
  const seconds = (performance.now() - begun_ms) / 1000;
  return { timings, rates, graphics_s: browserSeconds().graphics - begun_s, seconds };
}

function summary(phases: Phase[]): Growing {
  const timings = phases.flatMap((one) => one.timings);
  const frames = timings.filter(({ name }) => name === "globe.script").length;
  const sum = (of: (one: Phase) => number) => phases.reduce((all, one) => all + of(one), 0);
  return {
    graphics_ms: (1000 * sum((one) => one.graphics_s)) / frames,
    script: shares(timings, "globe.script"),
    frame: shares(timings, "globe.picture"),
    update: shares(timings, "track.update"),
    take: shares(timings, "track.take"),
    drawn_per_s: frames / sum((one) => one.seconds),
    frames_per_s: sum((one) => one.rates.frames_per_s) / phases.length,
    moved_per_s: sum((one) => one.rates.moved_per_s) / phases.length,
  };
}

async function framesSoFar(page: Page): Promise<number> {
  return await page.evaluate(() => window.timings.filter(({ name }) => name === "globe.script").length);
}

function shares(timings: Timing[], wanted: string): Shares {
  const took = timings.filter(({ name }) => name === wanted).map(({ took_ms }) => took_ms);
  took.sort((one, other) => one - other);
  const at = (share: number) => took[Math.min(took.length - 1, Math.floor(share * took.length))] ?? Number.NaN;
  const half = took.slice(Math.floor(took.length / 4), Math.ceil((3 * took.length) / 4));
  return { p50: at(0.5), p95: at(0.95), middle: half.reduce((sum, one) => sum + one, 0) / half.length };
}

/** Displayed frames of the page beside the globe, and in how many of them the attitude indicator moved. */
async function watchRates(page: Page, duration_ms: number): Promise<Rates> {
  return await page.evaluate(
    (wanted_ms) =>
      new Promise((resolve) => {
        let frames = 0;
        let moved = 0;
        let hasMoved = false;
        const instrument = document.querySelector('[aria-label="Indicador de actitud"]');
        const observer = new MutationObserver(() => {
          hasMoved = true;
        });
        observer.observe(instrument ?? document.body, { attributes: true, subtree: true, attributeFilter: ["style"] });
        const started = performance.now();
        const count = (now: number) => {
          frames += 1;
          moved += hasMoved ? 1 : 0;
          hasMoved = false;
          if (now - started < wanted_ms) {
            requestAnimationFrame(count);
          } else {
            observer.disconnect();
            const seconds = (now - started) / 1000;
            resolve({ frames_per_s: frames / seconds, moved_per_s: moved / seconds });
          }
        };
        requestAnimationFrame(count);
      }),
    duration_ms,
  );
}

/** What is kept of two hours: beside the points, and of each of them. */
async function measureHeap(page: Page, devtools: CDPSession) {
  const begin = await heapNow(page, devtools);
  await order(`/hasten?points=${BEGUN}&rate=${HASTE}`);
  await hasPoints(page, BEGUN);
  await settled(page);
  const begun = await heapNow(page, devtools);
  await order(`/hasten?points=${LONG - BEGUN}&rate=${HASTE}`);
  await hasPoints(page, LONG);
  await settled(page);
  const end = await heapNow(page, devtools);
  return {
    begin_mb: begin.all_mb,
    end_mb: end.all_mb,
    grown_mb: end.objects_mb - begun.objects_mb,
    bytes_per_point: ((end.all_mb - begin.all_mb) * 1e6) / LONG,
  };
}

/** After collecting: objects of scripts alone, and with what lies in arrays of bytes. */
async function heapNow(page: Page, devtools: CDPSession): Promise<{ objects_mb: number; all_mb: number }> {
  await page.evaluate(() => {
    window.timings = [];
  });
  await devtools.send("HeapProfiler.enable");
  await devtools.send("HeapProfiler.collectGarbage");
  await devtools.send("HeapProfiler.collectGarbage");
  const usage = (await devtools.send("Runtime.getHeapUsage")) as {
    usedSize: number;
    backingStorageSize: number;
  };
  return { objects_mb: usage.usedSize / 1e6, all_mb: (usage.usedSize + usage.backingStorageSize) / 1e6 };
}
