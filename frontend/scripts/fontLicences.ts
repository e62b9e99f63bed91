import { appendFileSync, readFileSync } from "node:fs";
import { join } from "node:path";
import type { Plugin } from "vite";

/** Fonts come by style sheets, and the list of licences that the build writes knows code alone. */
const FONTS = ["@fontsource-variable/inter", "@fontsource/b612-mono"];

/** Adds the fonts' licences to the file of licences beside the built page. */
export function fontLicences(folder: string, fileName: string): Plugin {
  return {
    name: "font-licences",
    apply: "build",
    // After all is written; a build that failed writes nothing, and says why itself.
    writeBundle() {
      for (const font of FONTS) {
        const text = readFileSync(join(folder, "node_modules", font, "LICENSE"), "utf8");
        appendFileSync(join(folder, "dist", fileName), `\n## ${font}\n\n${text}\n`);
      }
    },
  };
}
