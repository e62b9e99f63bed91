import { createContext, runInContext } from "node:vm";
import { expect, test } from "vitest";
import { type BuiltFile, workerText } from "../../scripts/pageWorkerFile";

const INDEX: BuiltFile = { fileName: "index.html", source: "<title>EPF GCS</title>" };
const BUILT: readonly BuiltFile[] = [
  INDEX,
  { fileName: "assets/index-1.js", source: "" },
  { fileName: "assets/index-1.js.map", source: "" },
  { fileName: "assets/globe-engine-2.js", source: "" },
  { fileName: "assets/cesium-24/Workers/a.js", source: "" },
  { fileName: "guide/es/flight.webp", source: "" },
];

interface Asked {
  readonly url: string;
  readonly method: string;
  readonly mode: string;
}

/** The worker as a browser runs it, with caches in memory and a network that can be away. */
function worker(text: string, kept = new Map<string, Map<string, string>>()) {
  const listeners = new Map<string, (event: object) => void>();
  const network = { isAway: false };
  const waits: Promise<unknown>[] = [];
  let skips = 0;
  const open = (name: string) => {
    const files = kept.get(name) ?? new Map<string, string>();
    kept.set(name, files);
    return {
      addAll: async (paths: readonly string[]) => {
        for (const path of paths) {
          files.set(path, `kept ${path}`);
        }
      },
      match: async (path: string) => files.get(path),
    };
  };
  const self = {
    location: { origin: "http://station" },
    addEventListener: (name: string, hear: (event: object) => void) => listeners.set(name, hear),
    skipWaiting: () => {
      skips += 1;
    },
  };
  runInContext(
    text,
    createContext({
      self,
      URL,
      AbortSignal,
      caches: {
        open: async (name: string) => open(name),
        keys: async () => [...kept.keys()],
        delete: async (name: string) => kept.delete(name),
      },
      fetch: async ({ url }: Asked) => {
        if (network.isAway) {
          throw new TypeError("away");
        }
        return `fresh ${url}`;
      },
    }),
  );
  return {
    kept,
    network,
    skips: () => skips,
    fire: async (name: string, event: object = {}) => {
      listeners.get(name)?.({ ...event, waitUntil: (wait: Promise<unknown>) => waits.push(wait) });
      await Promise.all(waits);
    },
    ask: async (path: string, mode = "cors", method = "GET") => {
      let answer: Promise<unknown> | null = null;
      const request: Asked = { url: new URL(path, "http://station").href, method, mode };
      listeners.get("fetch")?.({ request, respondWith: (given: Promise<unknown>) => (answer = given) });
      return answer === null ? "not touched" : await (answer as Promise<unknown>);
    },
  };
}

test("it keeps index.html and the page's hashed files, without the globe, maps of code and pictures", async () => {
  const made = worker(workerText(BUILT));
  await made.fire("install");
  expect([...made.kept.values()].map((files) => [...files.keys()])).toEqual([["/", "/assets/index-1.js"]]);
});

test("the version follows the contents: of file names and of index.html", () => {
  const version = (files: readonly BuiltFile[]): string => workerText(files).split("\n")[0] ?? "";
  expect(version(BUILT)).toBe(version([...BUILT].reverse()));
  expect(version(BUILT)).not.toBe(version([...BUILT, { fileName: "assets/new-3.js", source: "" }]));
  expect(version(BUILT)).not.toBe(version([{ ...INDEX, source: "other" }, ...BUILT.slice(1)]));
});

test("an answer of the station is never touched, whatever it is", async () => {
  const made = worker(workerText(BUILT));
  await made.fire("install");
  for (const path of [
    "/api/v1/status",
    "/api/v1/map/layers",
    "/health",
    "/metrics",
    "/api/docs",
    "/guide/es/a.webp",
  ]) {
    expect(await made.ask(path)).toBe("not touched");
    expect(await made.ask(path, "navigate")).toBe("not touched");
  }
  expect(await made.ask("http://elsewhere/assets/index-1.js")).toBe("not touched");
  expect(await made.ask("/", "navigate", "POST")).toBe("not touched");
});

test("the page is the station's own while it can be reached, and the kept one while it is away", async () => {
  const made = worker(workerText(BUILT));
  await made.fire("install");
  expect(await made.ask("/", "navigate")).toBe("fresh http://station/");
  made.network.isAway = true;
  expect(await made.ask("/", "navigate")).toBe("kept /");
  expect(await made.ask("/assets/index-1.js")).toBe("kept /assets/index-1.js");
});

test("a new version waits until it is wanted, and then removes what older ones kept", async () => {
  const kept = new Map([
    ["epf-page-old", new Map([["/", "old"]])],
    ["of another program", new Map()],
  ]);
  const made = worker(workerText(BUILT), kept);
  await made.fire("install");
  expect(made.skips()).toBe(0);
  await made.fire("message", { data: "activate" });
  expect(made.skips()).toBe(1);
  await made.fire("activate");
  expect([...kept.keys()].filter((name) => name === "epf-page-old")).toEqual([]);
  expect(kept.has("of another program")).toBe(true);
  expect(kept.size).toBe(2);
});
