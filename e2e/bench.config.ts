import { defineConfig } from "@playwright/test";
import base from "./playwright.config.js";

/** Measurements of the page, not journeys: `make bench` starts them beside a gateway that it feeds. */
export default defineConfig(base, { testDir: "bench", reporter: [["line"]], timeout: 900_000 });
