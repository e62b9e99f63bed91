import { existsSync } from "node:fs";
import { availableParallelism } from "node:os";
import { defineConfig } from "@playwright/test";
import { PATIENCE_MS } from "./support/processes.js";

// Debian's. The shell draws no window of its own, which spares the journeys a seventh of the processor.
const debian = ["/usr/bin/chromium-headless-shell", "/usr/bin/chromium"];
const system = (process.env.CHROMIUM === undefined ? debian : [process.env.CHROMIUM]).find((file) => existsSync(file));

/** A computation that takes so long leaves a core's half beside a flying station, which works by the clock. */
const ROOM_MS = 100;

/**
 * How many journeys have room at a time: on two slow cores one, whose browser would else wait for the others' flights;
 * on fast ones three, which wait for conditions half of the time. Measured in the processor's time, whatever else runs.
 */
function atOnce(): number {
  const begun = process.cpuUsage();
  let value = 0;
  for (let turn = 0; turn < 20_000_000; turn += 1) value = (value * 1_103_515_245 + turn) % 2_147_483_647;
  const { user } = process.cpuUsage(begun);
  return Math.min(Math.max(Math.round((availableParallelism() * ROOM_MS) / (user / 1000)), 1), 3);
}

export default defineConfig({
  testDir: "journeys",
  // For a station that runs already: only what needs no kill, no cable and no option of its own is tagged for it.
  globalSetup: "./support/there.ts",
  ...(process.env.GCS_STATION === undefined ? {} : { grep: /@any-station/ }),
  // Journeys that serve with any station share their worker's; each other has a board, a simulator and a gateway of its
  // own. A station that runs already has one operator.
  workers: process.env.GCS_STATION === undefined ? atOnce() : 1,
  fullyParallel: process.env.GCS_STATION === undefined,
  forbidOnly: true,
  retries: 0,
  // For what hangs, and longer than several waits one after the other: a walk through every tab takes minutes where the
  // globe is drawn by the processor alone.
  timeout: 1_200_000,
  expect: { timeout: PATIENCE_MS, toPass: { timeout: PATIENCE_MS } },
  reporter: process.env.PLAYWRIGHT_JUNIT_OUTPUT_FILE ? [["list"], ["junit"]] : [["list"]],
  use: {
    browserName: "chromium",
    // A click that nothing takes ends with the reason why not, long before the journey's own end.
    actionTimeout: PATIENCE_MS,
    navigationTimeout: PATIENCE_MS,
    // The page speaks the browser's language; the journeys read Spanish.
    locale: "es-ES",
    viewport: { width: 1366, height: 768 },
    launchOptions: system === undefined ? {} : { executablePath: system },
    screenshot: "only-on-failure",
    // It takes a tenth of the processor from the journeys: whoever looks for a fault asks for it with --trace on.
    trace: "off",
  },
});
