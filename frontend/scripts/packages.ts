import { readFileSync } from "node:fs";
import { join } from "node:path";

/** A package that the page brings to the browser. */
export interface PagePackage {
  readonly name: string;
  readonly version: string;
  readonly licence: string | null;
}

interface Locked {
  readonly version?: string;
  readonly license?: string;
  readonly dev?: boolean;
  readonly devOptional?: boolean;
}

/** What the map shows that others have made, and no package manager knows: beside this file. */
const DATA = "scripts/mapData.json";

/** Everything in the lock file that is no tool of the developers, with the licence that each package names itself. */
export function pagePackages(folder: string): PagePackage[] {
  const lock = read<{ packages: Readonly<Record<string, Locked>> }>(join(folder, "package-lock.json"));
  const packages = Object.entries(lock.packages)
    .filter(([path, { dev, devOptional }]) => path !== "" && dev !== true && devOptional !== true)
    .map(([path, { version = "", license }]) => ({
      name: path.slice(path.lastIndexOf("node_modules/") + "node_modules/".length),
      version,
      licence: license ?? licenceOf(join(folder, path, "package.json")),
    }));
  const data = read<readonly PagePackage[]>(join(folder, DATA));
  return [...packages, ...data].sort((first, second) => first.name.localeCompare(second.name, "en"));
}

function licenceOf(path: string): string | null {
  return read<{ license?: string }>(path).license ?? null;
}

function read<T>(path: string): T {
  return JSON.parse(readFileSync(path, "utf8")) as T;
}
