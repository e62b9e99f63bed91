import type { Plugin } from "vite";

/**
 * What the globe's engine does that the gateway's content policy forbids: styles written as text, each an error on the
 * console. Neither is needed: the credits' styles are for a box that the page does not show, and a property can be
 * asked for as a property.
 */
const INLINE_STYLES: ReadonlyArray<{
  readonly file: string;
  readonly before: string;
  readonly after: string;
}> = [
  {
    file: "@cesium/engine/Source/Scene/CreditDisplay.js",
    before: "  shadowRootOrDocumentHead.appendChild(styleElem);\n",
    after: "",
  },
  {
    file: "@cesium/engine/Source/Scene/CreditDisplay.js",
    before: "  styleElem.innerHTML = style;\n",
    after: "",
  },
  {
    file: "@cesium/engine/Source/Core/FeatureDetection.js",
    before: `    canvas.setAttribute(
      "style",
      "image-rendering: -moz-crisp-edges;" + "image-rendering: pixelated;",
    );
`,
    after: `    canvas.style.imageRendering = "pixelated";\n`,
  },
];

/** Builds the engine without inline styles; another version of it that has them elsewhere stops the build. */
export function globePolicy(): Plugin {
  return {
    name: "globe-policy",
    apply: "build",
    transform(code, id) {
      const changes = INLINE_STYLES.filter(({ file }) => id.endsWith(file));
      return changes.length === 0 ? null : { code: changes.reduce(applied, code), map: null };
    },
  };
}

function applied(code: string, { file, before, after }: (typeof INLINE_STYLES)[number]): string {
  if (!code.includes(before)) {
    throw new Error(`${file} has changed: look for inline styles in it, which the content policy forbids`);
  }
  return code.replace(before, after);
}
