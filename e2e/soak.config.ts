import { defineConfig } from "@playwright/test";
import base from "./playwright.config.js";

/** The long flight is not a journey: `make soak` asks for it. */
export default defineConfig(base, { testDir: "soak", workers: 1, reporter: [["list"]] });
