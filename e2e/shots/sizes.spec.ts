import { mkdir, writeFile } from "node:fs/promises";
import { expect, open, test } from "../support/fixtures.js";
import { SIZES, sizeName, Walk } from "../support/walk.js";

const FOLDER = "test-results/sizes";
/** `SIZES=360x640,1024x768` and `LANGUAGES=es` take a part of it. */
const { SIZES: wanted, LANGUAGES: spoken = "es,en", LOOKS: looks = "dark" } = process.env;

/** Every tab, dialog and menu in every window and both languages: pictures to be looked at, and all that was measured wrong. */
test("every tab, dialog and menu in every window", async ({ page, flying }) => {
  await mkdir(FOLDER, { recursive: true });
  await open(page, flying);
  let picture = "";
  const walk = await Walk.of(page, async (what) => {
    const name = `${picture}-${what}`.replaceAll(/[^\wáéíóúñ-]+/gi, "_");
    await page.screenshot({ path: `${FOLDER}/${name}.jpg`, type: "jpeg", quality: 60 });
  });
  const faults: string[] = [];
  for (const look of looks.split(",")) {
    await walk.wear(look);
    for (const language of spoken.split(",") as ("es" | "en")[]) {
      await walk.speak(language);
      for (const size of SIZES.filter((one) => wanted === undefined || wanted.split(",").includes(sizeName(one)))) {
        picture = `${sizeName(size)}-${language}-${look}`;
        await walk.resize(size);
        faults.push(...(await walk.tabs()).map((fault) => `${language} ${look} ${fault}`));
        faults.push(...(await walk.overlays()).map((fault) => `${language} ${look} ${fault}`));
        await writeFile(`${FOLDER}/faults.txt`, faults.join("\n"));
      }
    }
  }
  expect(faults).toEqual([]);
});
