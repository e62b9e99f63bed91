import { defineConfig } from "@playwright/test";
import base from "./playwright.config.js";

/** Pictures are no journeys: `npm run shots` and `npm run guide-shots` ask for them. */
export default defineConfig(base, {
  testDir: "shots",
  workers: 1,
  timeout: 1_800_000,
  reporter: [["list"]],
  // What is not there is said, and not waited for until the end.
  use: { ...base.use, actionTimeout: 60_000 },
});
