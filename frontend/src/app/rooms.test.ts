import { readdirSync, readFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { expect, test } from "vitest";

const source = join(import.meta.dirname, "..");
const folders = readdirSync(source, { withFileTypes: true })
  .filter((entry) => entry.isDirectory())
  .map(({ name }) => name);

interface Override {
  readonly includes: readonly string[];
  readonly linter: { readonly rules: { readonly style?: { readonly noRestrictedImports?: unknown } } };
}

const { overrides } = JSON.parse(readFileSync(join(source, "../biome.json"), "utf8")) as {
  readonly overrides: readonly Override[];
};
const ruled = overrides
  .filter(({ linter }) => linter.rules.style?.noRestrictedImports !== undefined)
  .flatMap(({ includes }) => includes)
  .filter((pattern) => !pattern.startsWith("!"))
  .map((pattern) => pattern.split("/")[1] ?? "");

test("every room of the page has its import rule; app wires them all and test helps them all", () => {
  const free = ["app", "test"];
  expect(folders.filter((room) => !free.includes(room) && !ruled.includes(room))).toEqual([]);
});

test("every import rule is about a room that is there", () => {
  expect(ruled.length).toBeGreaterThan(5);
  expect(ruled.filter((room) => !folders.includes(room))).toEqual([]);
});

test("a rule that forbids rooms names each of them as its folder is named", () => {
  const text = readFileSync(join(source, "../biome.json"), "utf8");
  const forbidden = [...text.matchAll(/"\*\*\/(\w+)\/\*\*"/g)].map((match) => match[1] ?? "");
  expect(forbidden.length).toBeGreaterThan(20);
  expect([...new Set(forbidden)].filter((room) => !folders.includes(room))).toEqual([]);
});

/** The folders that each folder's files import from, without tests. */
function importsOfFolders(): Map<string, Set<string>> {
  const imports = new Map<string, Set<string>>();
  for (const name of readdirSync(source, { recursive: true, encoding: "utf8" })) {
    if (!/\.tsx?$/.test(name) || /\.test\.tsx?$/.test(name)) {
      continue;
    }
    const folder = dirname(name);
    const reached = imports.get(folder) ?? new Set();
    imports.set(folder, reached);
    for (const [, path = ""] of readFileSync(join(source, name), "utf8").matchAll(
      /(?:from|import) ?\(?"(\.[^"]+)"/g,
    )) {
      reached.add(dirname(join(folder, path)));
    }
  }
  return imports;
}

test("no folder of the page is reached again from what it imports", () => {
  const imports = importsOfFolders();
  const circles = [...imports.keys()].filter((folder) => {
    const seen = new Set<string>();
    const next = [...(imports.get(folder) ?? [])].filter((reached) => reached !== folder);
    for (let reached = next.pop(); reached !== undefined; reached = next.pop()) {
      if (!seen.has(reached)) {
        seen.add(reached);
        next.push(...(imports.get(reached) ?? []));
      }
    }
    return seen.has(folder);
  });
  expect(imports.size).toBeGreaterThan(40);
  expect(circles).toEqual([]);
});
