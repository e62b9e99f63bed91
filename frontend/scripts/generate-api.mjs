/**
 * Writes what the page has of the gateway's OpenAPI document: the guards of its answers, their schemas for the
 * tests, and who may ask what; and what the gateway has of the page's words. With --check only compares. Usage: npm run generate -- <openapi.json>
 */
import { readFile, writeFile } from "node:fs/promises";
import { fileURLToPath } from "node:url";
import { runnerImport } from "vite";

const check = process.argv.includes("--check");
const source = process.argv.slice(2).find((argument) => !argument.startsWith("--"));
if (source === undefined) {
  console.error("Name the OpenAPI document: npm run generate -- <openapi.json>");
  process.exit(2);
}

// Node runs no TypeScript of its own before version 22.18.
const load = async (name) =>
  (await runnerImport(fileURLToPath(new URL(name, import.meta.url)), { configFile: false })).module;
const module = await load("guards.ts");
const access = await load("accessTable.ts");
const document = JSON.parse(await readFile(source, "utf8"));
const texts = {
  "src/protocol/access.gen.ts": access.accessModule(document),
  "src/protocol/guards.gen.ts": module.guardsModule(document),
  "src/test/schemas.gen.ts": module.schemasModule(document),
};

// The report as a page of its own is made by the gateway, in the words of the page's report.
for (const language of ["es", "en"]) {
  const words = async (feature) =>
    JSON.parse(
      await readFile(new URL(`../src/features/${feature}.${language}.json`, import.meta.url), "utf8"),
    );
  const { report } = await words("report/report");
  const { alarmName } = await words("alarms/alarms");
  const target = `../backend/src/epf_gcs/flights/report/words_gen.${language}.json`;
  texts[target] = `${JSON.stringify({ ...report, alarmNames: alarmName }, null, 2)}\n`;
}

for (const [name, text] of Object.entries(texts)) {
  const target = fileURLToPath(new URL(`../${name}`, import.meta.url));
  if (!check) {
    await writeFile(target, text);
  } else if ((await readFile(target, "utf8").catch(() => "")) !== text) {
    console.error(`${name} is out of date: run \`make generate\` and commit the result.`);
    process.exitCode = 1;
  }
}
