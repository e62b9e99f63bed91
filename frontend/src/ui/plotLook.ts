import type uPlot from "uplot";

/** Width of a digit in the number font. */
const EM_PER_FIGURE = 0.65;
/** Greatest number of units with their own axis; there is no room for more. */
export const MOST_AXES = 4;

export function sizeOf(element: HTMLElement): { width: number; height: number } {
  return { width: Math.max(1, element.clientWidth), height: Math.max(1, element.clientHeight) };
}

export interface Look {
  readonly colour: (token: string) => string;
  readonly fontSize_px: number;
  readonly fontFamily: string;
}

/** The theme's colours, read once and not per drawing: each query makes the browser compute styles. */
export function lookOf(element: HTMLElement): Look {
  const style = getComputedStyle(element);
  const known = new Map<string, string>();
  return {
    colour: (token) => {
      const colour = known.get(token) ?? style.getPropertyValue(token).trim();
      known.set(token, colour);
      return colour;
    },
    fontSize_px: Number.parseFloat(style.fontSize) || 12,
    fontFamily: style.getPropertyValue("--font-number").trim() || "monospace",
  };
}

export function scaleOf(unit: string): string {
  return `y ${unit}`;
}

/** Margins above and below; a constant signal is drawn in the middle. */
export function roomy(_: uPlot, min: number | null, max: number | null): uPlot.Range.MinMax {
  if (min === null || max === null) {
    return [-1, 1];
  }
  const least = Math.max(1e-3, Math.abs(max) * 1e-3);
  const pad = max - min < least ? least : (max - min) * 0.08;
  return [min - pad, max + pad];
}

/** Wide enough for the longest number, and for at least five digits, so that the plot does not jump. */
export function axisWidth(values: readonly string[] | null, fontSize_px: number): number {
  const longest = Math.max(5, ...(values ?? []).map((text) => text.length));
  return Math.ceil(longest * EM_PER_FIGURE * fontSize_px) + 10;
}
