import react from "@vitejs/plugin-react";
import { defineConfig } from "vitest/config";
import { fontLicences } from "./scripts/fontLicences.ts";
import { globeAssets, globeAssetsPath } from "./scripts/globeAssets.ts";
import { globePolicy } from "./scripts/globePolicy.ts";
import { pagePackages } from "./scripts/packages.ts";
import { pageWorker } from "./scripts/pageWorkerFile.ts";

/** Where `npm run dev` finds the gateway. */
const gateway = process.env["GCS_DEV_GATEWAY"] ?? "http://127.0.0.1:8000";

/** Beside the page; the about window links it. */
const LICENCES = "licences.txt";

export default defineConfig({
  plugins: [
    react(),
    globeAssets(import.meta.dirname),
    globePolicy(),
    fontLicences(import.meta.dirname, LICENCES),
    pageWorker(),
  ],
  // Read when the page is built, so that the about window needs no network and cannot be out of date.
  define: {
    // Where the globe's engine looks for its own files.
    CESIUM_BASE_URL: JSON.stringify(globeAssetsPath(import.meta.dirname)),
    PAGE_PACKAGES: JSON.stringify(pagePackages(import.meta.dirname)),
  },
  build: {
    outDir: "dist",
    target: "es2023",
    // The gateway's content policy is `self` only: nothing may be inlined as a data: script, and the
    // module preload helper would be an inline script.
    assetsInlineLimit: 0,
    modulePreload: { polyfill: false },
    // The licence texts of all packages whose code is in the page, beside the page.
    license: { fileName: LICENCES },
    rolldownOptions: {
      output: {
        // What changes least is kept longest by the browser: the framework, then the words.
        codeSplitting: {
          groups: [
            {
              name: "framework",
              test: /node_modules[\\/](react|react-dom|scheduler|i18next|react-i18next|zustand)[\\/]/,
            },
            // In one piece, and in no other: only the map's tab asks for it.
            { name: "globe-engine", test: /node_modules[\\/]@cesium[\\/]/ },
            { name: "words", test: /src[\\/].*\.(es|en)\.json$/ },
          ],
        },
      },
    },
  },
  // Known before the map is first opened, or that would reload the page in development.
  optimizeDeps: { include: ["@cesium/engine"] },
  server: {
    host: "127.0.0.1",
    proxy: { "/api": { target: gateway, ws: true, changeOrigin: true } },
  },
  test: {
    restoreMocks: true,
    allowOnly: false,
    // Far above what any takes: a busy machine shall not fail a test.
    testTimeout: 240_000,
    hookTimeout: 240_000,
    expect: { poll: { timeout: 120_000 } },
    // One worker less than cores is the default, which on two cores is one.
    maxWorkers: "100%",
    // A worker's files share its modules, which is half of the time; what a test changes is its own page's.
    isolate: false,
    coverage: {
      provider: "v8",
      include: ["src/**/*.{ts,tsx}"],
      // Generated, or only there for the tests. What needs a real browser's graphics is tried by the journeys.
      exclude: ["src/**/*.gen.ts", "src/**/*.test.*", "src/test/**", "src/main.tsx"],
      reporter: ["text-summary"],
      // Where it stands; raised when it grows, never lowered.
      thresholds: { branches: 77, functions: 81, lines: 81, statements: 81 },
    },
    projects: [
      { extends: true, test: { name: "logic", environment: "node", include: ["src/**/*.test.ts"] } },
      {
        extends: true,
        test: {
          name: "page",
          environment: "jsdom",
          include: ["src/**/*.test.tsx"],
          setupFiles: ["src/test/setup.ts"],
        },
      },
    ],
  },
});
