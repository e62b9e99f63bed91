import type { Palette } from "../../scene/attitude/palette";

const TOKENS: Readonly<Record<keyof Palette, string>> = {
  background: "--surface-well",
  text: "--text",
  muted: "--text-muted",
  line: "--line-control",
  body: "--model-body",
  belly: "--model-belly",
  glass: "--model-glass",
  left: "--model-left",
  right: "--model-right",
  grey: "--model-grey",
  axisX: "--plot-1",
  axisY: "--plot-3",
  axisZ: "--plot-5",
  acceleration: "--caution",
  field: "--guidance",
  warning: "--warning",
  good: "--engaged",
};

/** The theme's colours, as this element has them. */
export function paletteOf(element: HTMLElement): Palette {
  const style = getComputedStyle(element);
  const colours = Object.entries(TOKENS).map(([name, token]) => [
    name,
    style.getPropertyValue(token).trim() || "#808080",
  ]);
  return Object.fromEntries(colours) as Record<keyof Palette, string>;
}
