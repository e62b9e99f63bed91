import { createHash } from "node:crypto";
import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import type { Plugin } from "vite";

const FILE_NAME = "sw.js";
const INDEX = "index.html";
/** Hashed files that only the map asks for: large, and of no use while the station cannot be reached. */
const LEFT_OUT = /^assets\/(cesium-|globe-engine)/;

/** A file of the build; `source` as text or bytes for index.html. */
export interface BuiltFile {
  readonly fileName: string;
  readonly source: string | Uint8Array;
}

/**
 * The worker's text for these files of a build. The version follows the contents: names of hashed files say what is in
 * them, index.html is read.
 */
export function workerText(files: readonly BuiltFile[]): string {
  const index = files.find(({ fileName }) => fileName === INDEX);
  if (index === undefined) {
    throw new Error("the build has no index.html for the service worker to keep");
  }
  const kept = files
    .map(({ fileName }) => fileName)
    .filter((name) => name.startsWith("assets/") && !name.endsWith(".map") && !LEFT_OUT.test(name))
    .sort();
  const version = createHash("sha256")
    .update(kept.join("\n"))
    .update(index.source)
    .digest("hex")
    .slice(0, 16);
  const paths = ["/", ...kept.map((name) => `/${name}`)];
  const text = readFileSync(fileURLToPath(new URL("pageWorker.js", import.meta.url)), "utf8");
  return `const VERSION = ${JSON.stringify(version)};\nconst FILES = ${JSON.stringify(paths)};\n${text}`;
}

/** Writes the service worker beside index.html, after all else is built. */
export function pageWorker(): Plugin {
  return {
    name: "page-worker",
    apply: "build",
    enforce: "post",
    generateBundle: {
      order: "post",
      handler(_options, bundle) {
        const files = Object.values(bundle).map((file) => ({
          fileName: file.fileName,
          source: file.type === "asset" ? file.source : file.code,
        }));
        this.emitFile({ type: "asset", fileName: FILE_NAME, source: workerText(files) });
      },
    },
  };
}
