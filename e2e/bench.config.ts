import { defineConfig } from "@playwright/test";
import base from "./playwright.config.js";

/** Measurements of the page, not journeys: `make bench` starts them beside a gateway that it feeds. */
export default defineConfig(base, {
  testDir: "bench",
  // Nothing beside what is measured.
  workers: 1,
  reporter: [["line"]],
  timeout: 900_000,
  // A trace films the page, and would be measured with it.
  use: { ...base.use, trace: "off", screenshot: "off" },
});
