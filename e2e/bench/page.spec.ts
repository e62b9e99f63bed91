import { readFile, writeFile } from "node:fs/promises";
import path from "node:path";
import { type Browser, type CDPSession, expect, type Page, test } from "@playwright/test";
import { openTab, TABS } from "../support/tabs.js";
import { browserSeconds } from "./processor.js";

/** The gateway's address, where the figures go, and how long each tab is measured. */
const URL = process.env.BENCH_URL ?? "";
const RESULTS = process.env.BENCH_RESULTS ?? "";
const SECONDS = Number(process.env.BENCH_SECONDS ?? "12");

/** Has a redraw budget and measurements of its own. */
const GLOBE = /^Mapa 3D$/;
/** Goes before the tabs, with the name that the table knows. */
const LEAN = "lean";

type Figures = {
  tab: string;
  frames_per_s: number;
  script_percent: number;
  cpu_percent: number;
  longest_task_ms: number;
  heap_mb: number;
};

test("the page with twelve topics at 50 Hz, tab by tab", async ({ page, browser }) => {
  if (URL === "") throw new Error("`make bench` starts this and says where the gateway is");
  const leanBefore = await measureLean(browser);
  const figures: Figures[] = [];
  await page.goto(URL, { waitUntil: "domcontentloaded" });
  const devtools = await page.context().newCDPSession(page);
  await devtools.send("Performance.enable");
  await devtools.send("HeapProfiler.enable");
  for (const name of TABS.filter((tab) => !GLOBE.test(tab))) {
    await openTab(page, name);
    // A tab's own part is loaded and laid out once; what counts is how it goes on.
    await page.waitForTimeout(3000);
    figures.push({ tab: name, ...(await measure(page, devtools)) });
  }
  await page.close();
  // Before and after: a computer that others use is not as fast at the end as at the beginning.
  const leanAfter = await measureLean(browser);
  const cpu_percent = (leanBefore.cpu_percent + leanAfter.cpu_percent) / 2;
  await writeFile(RESULTS, JSON.stringify([{ tab: LEAN, ...leanAfter, cpu_percent }, ...figures]));
});

/** The leanest page that shows the same stream, from the same gateway in the same run: what a browser costs at all. */
async function measureLean(browser: Browser): Promise<Omit<Figures, "tab">> {
  // Put in the place of something that the gateway served, for only from there may a page open its stream.
  const lean = await browser.newPage({ bypassCSP: true, viewport: { width: 1366, height: 768 } });
  await lean.goto(`${URL}/api/v1/status`);
  await lean.setContent(await readFile(path.join(import.meta.dirname, "lean.html"), "utf8"));
  await expect(lean.locator("#numbers span").nth(149)).not.toBeEmpty();
  const devtools = await lean.context().newCDPSession(lean);
  await devtools.send("Performance.enable");
  await devtools.send("HeapProfiler.enable");
  const figures = await measure(lean, devtools);
  await lean.close();
  return figures;
}

async function measure(page: Page, devtools: CDPSession): Promise<Omit<Figures, "tab">> {
  const [script, cpu] = [await scriptSeconds(devtools), browserSeconds().browser];
  const { frames, seconds, longest_ms } = await page.evaluate(
    (duration_ms) =>
      new Promise<{ frames: number; seconds: number; longest_ms: number }>((resolve) => {
        let longest_ms = 0;
        const observer = new PerformanceObserver((list) => {
          for (const entry of list.getEntries()) longest_ms = Math.max(longest_ms, entry.duration);
        });
        observer.observe({ type: "longtask" });
        let frames = 0;
        const started = performance.now();
        const count = (now: number) => {
          frames += 1;
          if (now - started < duration_ms) {
            requestAnimationFrame(count);
          } else {
            observer.disconnect();
            resolve({ frames, seconds: (now - started) / 1000, longest_ms });
          }
        };
        requestAnimationFrame(count);
      }),
    SECONDS * 1000,
  );
  const [scriptAfter, cpuAfter] = [await scriptSeconds(devtools), browserSeconds().browser];
  await devtools.send("HeapProfiler.collectGarbage");
  const { usedSize } = await devtools.send("Runtime.getHeapUsage");
  return {
    frames_per_s: frames / seconds,
    script_percent: (100 * (scriptAfter - script)) / seconds,
    cpu_percent: (100 * (cpuAfter - cpu)) / seconds,
    longest_task_ms: longest_ms,
    heap_mb: usedSize / 1e6,
  };
}

async function scriptSeconds(devtools: CDPSession): Promise<number> {
  const { metrics } = await devtools.send("Performance.getMetrics");
  return metrics.find(({ name }) => name === "ScriptDuration")?.value ?? Number.NaN;
}
