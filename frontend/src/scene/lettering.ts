import { Color, LabelStyle } from "@cesium/engine";
import { EDGE } from "./colours";

/** Nearer than this, metres, a mark is visible even through the ground: it must never be lost. */
export const THROUGH_GROUND_M = 400_000;

const FAMILY = '"Inter Variable", system-ui, sans-serif';
export const STRONG_FONT = `700 16px ${FAMILY}`;

/** Lettering on the globe: with a dark outline, readable on any ground. */
export const LETTERING = {
  font: `600 15px ${FAMILY}`,
  style: LabelStyle.FILL_AND_OUTLINE,
  outlineColor: Color.fromCssColorString(EDGE),
  outlineWidth: 3,
  disableDepthTestDistance: THROUGH_GROUND_M,
};
