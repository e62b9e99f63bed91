/**
 * Change the page's code in one small place at a time and see whether the tests beside it notice. Stryker makes the
 * changes, in a copy of the page. Those that no test notices are printed with their difference: each is a test that is
 * missing, or code that is not needed.
 *
 *     node mutation/mutate.mjs [folder or file ...] [--share 0.1]
 *
 * `--share`: only so much of the files, chosen at random. Without names: all three rooms.
 */
import { readdirSync, readFileSync, statSync } from "node:fs";
import { dirname, join } from "node:path";
import { parseArgs } from "node:util";
import { Stryker } from "@stryker-mutator/core";

const ROOMS = ["src/lib", "src/store", "src/instruments"];
const here = import.meta.dirname;

const { values, positionals } = parseArgs({
  allowPositionals: true,
  options: { share: { type: "string", default: "1" } },
});
process.chdir(dirname(here));
const share = Number(values.share);
if (!(share > 0 && share <= 1)) {
  throw new Error(`--share is a part between 0 and 1, not ${values.share}`);
}
const files = (positionals.length === 0 ? ROOMS : positionals)
  .flatMap((path) =>
    statSync(path).isDirectory()
      ? readdirSync(path, { recursive: true }).map((name) => join(path, name))
      : [path],
  )
  .filter((path) => /\.tsx?$/.test(path) && !/\.(test|gen|d)\.tsx?$/.test(path));
const chosen = files
  .map((path) => ({ path, lot: Math.random() }))
  .sort((one, other) => one.lot - other.lot)
  .slice(0, Math.max(1, Math.round(files.length * share)))
  .map(({ path }) => path)
  .sort();
// Read by vitest.config.ts, in Stryker's own processes.
process.env.MUTATED_ROOMS = [...new Set(chosen.map((path) => path.split("/")[1]))].join("|");
console.log(`${chosen.length} of ${files.length} files`);

const report = join(here, "build", "mutation.json");
await new Stryker({
  configFile: join(here, "stryker.config.json"),
  mutate: chosen,
  jsonReporter: { fileName: report },
}).runMutationTest();

/** Of each room: how many changes were noticed, of how many. A change that hangs was noticed, too. */
const rooms = new Map();
for (const [path, { mutants }] of Object.entries(JSON.parse(readFileSync(report, "utf8")).files)) {
  const room = path.split("/").slice(0, 2).join("/");
  const count = rooms.get(room) ?? { killed: 0, all: 0 };
  for (const { status } of mutants) {
    count.killed += Number(status === "Killed" || status === "Timeout");
    count.all += Number(["Killed", "Timeout", "Survived", "NoCoverage"].includes(status));
  }
  rooms.set(room, count);
}
for (const [room, { killed, all }] of rooms) {
  console.log(`${room}: ${killed} of ${all} killed (${((100 * killed) / all).toFixed(1)} %)`);
}
