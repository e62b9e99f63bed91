import type uPlot from "uplot";
import { formatFixed } from "../lib/format";

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

/** Colours and fonts of every axis. */
export function axisLook({ colour, fontSize_px, fontFamily }: Look) {
  const font = `${fontSize_px}px ${fontFamily}`;
  return {
    stroke: () => colour("--text-muted"),
    font,
    labelFont: font,
    grid: { stroke: () => colour("--surface-3"), width: 1 },
    ticks: { stroke: () => colour("--line-control"), width: 1, size: 4 },
  } as const;
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

/** Numbers in a decade at which a steady axis may end. */
const ROUND = [1, 2, 5, 10] as const;
/** About as many steps from end to end. */
const STEPS = 5;

/**
 * The ends of an axis that shows at least `least_span` and ends at round numbers: a small noise does not fill the
 * picture, and the axis stands still until a value leaves it.
 */
export function steady(
  least_span: number,
): (_: uPlot, min: number | null, max: number | null) => uPlot.Range.MinMax {
  return (_, min, max) => {
    const [low, high] = min === null || max === null ? [0, 0] : [min, max];
    const short = Math.max(0, least_span - (high - low)) / 2;
    const [from, to] = [low - short, high + short];
    const raw = (to - from) / STEPS;
    const decade = 10 ** Math.floor(Math.log10(raw));
    const step = decade * (ROUND.find((round) => round * decade >= raw * (1 - 1e-9)) ?? 10);
    return [Math.floor(from / step) * step, Math.ceil(to / step) * step];
  };
}

const MOST_DIGITS = 9;

/** A number of an axis, with as many digits as its step has: by itself uPlot writes it in the browser's way. */
export function axisNumber(value: number, step: number): string {
  let digits = 0;
  for (
    let whole = step;
    Math.abs(whole - Math.round(whole)) > 1e-6 * whole && digits < MOST_DIGITS;
    whole *= 10
  ) {
    digits += 1;
  }
  return formatFixed(value, digits) ?? "";
}

/** Wide enough for the longest number, and for at least five digits, so that the plot does not jump. */
export function axisWidth(values: readonly string[] | null, fontSize_px: number): number {
  const longest = Math.max(5, ...(values ?? []).map((text) => text.length));
  return Math.ceil(longest * EM_PER_FIGURE * fontSize_px) + 10;
}
