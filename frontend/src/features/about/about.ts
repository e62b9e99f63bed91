import { type Checked, isText, list, nullable, oneOf, shape } from "../../lib/check";
import type { components } from "../../protocol/api.gen";

/** Versions of the gateway and its libraries, and the open board. */
export const isAbout = shape({
  version: isText,
  python: isText,
  platform: isText,
  board: nullable(
    shape({ name: nullable(isText), version: nullable(isText), mode: oneOf("legacy", "extended") }),
  ),
  packages: list(shape({ name: isText, version: isText, licence: nullable(isText) })),
});

export type About = Checked<typeof isAbout>;

/** Does not compile when the gateway describes it otherwise than it is checked here. */
export const aboutIsAsDescribed: components["schemas"]["About"] extends About ? true : false = true;
