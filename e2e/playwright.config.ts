import { existsSync } from "node:fs";
import { defineConfig } from "@playwright/test";
import { PATIENCE_MS } from "./support/processes.js";

// Debian's. The shell draws no window of its own, which spares the journeys a seventh of the processor.
const debian = ["/usr/bin/chromium-headless-shell", "/usr/bin/chromium"];
const system = (process.env.CHROMIUM === undefined ? debian : [process.env.CHROMIUM]).find((file) => existsSync(file));

export default defineConfig({
  testDir: "journeys",
  // For a station that runs already: only what needs no kill, no cable and no option of its own is tagged for it.
  globalSetup: "./support/there.ts",
  ...(process.env.GCS_STATION === undefined ? {} : { grep: /@any-station/ }),
  // Journeys that serve with any station share their worker's; each other has a board, a simulator and a gateway of its
  // own. All wait for conditions alone, half of the time: two cores have room for three at a time. A station that runs
  // already has one operator.
  workers: process.env.GCS_STATION === undefined ? 3 : 1,
  fullyParallel: process.env.GCS_STATION === undefined,
  forbidOnly: true,
  retries: 0,
  // For what hangs, and longer than several waits one after the other: a walk through every tab takes minutes where the
  // globe is drawn by the processor alone.
  timeout: 1_200_000,
  expect: { timeout: PATIENCE_MS },
  reporter: process.env.PLAYWRIGHT_JUNIT_OUTPUT_FILE ? [["list"], ["junit"]] : [["list"]],
  use: {
    browserName: "chromium",
    // The page speaks the browser's language; the journeys read Spanish.
    locale: "es-ES",
    viewport: { width: 1366, height: 768 },
    launchOptions: system === undefined ? {} : { executablePath: system },
    screenshot: "only-on-failure",
    // It takes a tenth of the processor from the journeys: whoever looks for a fault asks for it with --trace on.
    trace: "off",
  },
});
