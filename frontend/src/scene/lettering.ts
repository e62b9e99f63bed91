import { Color, LabelStyle } from "@cesium/engine";
import { EDGE } from "./colours";

/** Nearer than this, metres, a mark is seen through the ground before it: it must never be lost. */
export const THROUGH_GROUND_M = 400_000;

const FAMILY = '"Inter Variable", system-ui, sans-serif';
export const STRONG_FONT = `700 16px ${FAMILY}`;

/** How words are written on the globe: with a dark edge, which is read on any ground. */
export const LETTERING = {
  font: `600 15px ${FAMILY}`,
  style: LabelStyle.FILL_AND_OUTLINE,
  outlineColor: Color.fromCssColorString(EDGE),
  outlineWidth: 3,
  disableDepthTestDistance: THROUGH_GROUND_M,
};
