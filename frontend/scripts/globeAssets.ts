import { createReadStream, readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import type { Plugin } from "vite";

const PACKAGE = "node_modules/@cesium/engine";
/** Workers by what begins their file name: geometry and terrain. Those for point clouds, splats and foreign servers stay out. */
const WORKERS =
  /^(combineGeometry|create\w+Geometry|createVerticesFrom(Heightmap|QuantizedTerrainMesh)|upsampleQuantizedTerrainMesh|transferTypedArrayTest|incrementallyBuildTerrainPicker)\.js$/;
/** Natural Earth, the heights for what lies on the ground, and the Earth's orientation on the one day that the globe shows. */
const ASSETS =
  /^(Textures\/NaturalEarthII\/.+|approximateTerrainHeights\.json|IAU2006_XYS\/IAU2006_XYS_1[89]\.json)$/;
const TYPES: Readonly<Record<string, string>> = {
  js: "text/javascript",
  json: "application/json",
  jpg: "image/jpeg",
  xml: "application/xml",
};

/** Where the globe's workers and pictures lie in the page: the version is in the name, so that a browser may keep them. */
export function globeAssetsPath(folder: string): string {
  const { version } = JSON.parse(readFileSync(join(folder, PACKAGE, "package.json"), "utf8")) as {
    version: string;
  };
  return `/assets/cesium-${version}/`;
}

/** The files of the globe which it fetches by itself while it runs: served by the development server, copied by the build. */
export function globeAssets(folder: string): Plugin {
  const base = globeAssetsPath(folder);
  const files = neededFiles(join(folder, PACKAGE));
  return {
    name: "globe-assets",
    configureServer(server) {
      server.middlewares.use((request, response, next) => {
        const path = request.url?.split("?")[0] ?? "";
        const source = path.startsWith(base) ? files.get(path.slice(base.length)) : undefined;
        if (source === undefined) {
          next();
          return;
        }
        response.setHeader("Content-Type", TYPES[path.slice(path.lastIndexOf(".") + 1)] ?? "");
        createReadStream(source).pipe(response);
      });
    },
    generateBundle() {
      for (const [name, source] of files) {
        this.emitFile({ type: "asset", fileName: `${base.slice(1)}${name}`, source: readFileSync(source) });
      }
    },
  };
}

/** Every file by its name below the base. */
function neededFiles(folder: string): Map<string, string> {
  const workers = join(folder, "Build/Workers");
  const assets = join(folder, "Source/Assets");
  return new Map([
    ...withImports(
      workers,
      readdirSync(workers).filter((name) => WORKERS.test(name)),
    ).map((name) => [`Workers/${name}`, join(workers, name)] as const),
    ...readdirSync(assets, { recursive: true, encoding: "utf8" })
      .map((name) => name.replaceAll("\\", "/"))
      .filter((name) => ASSETS.test(name) && /\.\w+$/.test(name))
      .map((name) => [`Assets/${name}`, join(assets, name)] as const),
  ]);
}

/** The files and all that they import from beside them. */
function withImports(folder: string, names: readonly string[]): string[] {
  const found = new Set(names);
  for (const name of found) {
    for (const match of readFileSync(join(folder, name), "utf8").matchAll(/["']\.\/([\w-]+\.js)["']/g)) {
      found.add(match[1] ?? "");
    }
  }
  return [...found];
}
