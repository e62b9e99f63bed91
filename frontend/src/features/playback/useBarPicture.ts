import { type RefObject, useEffect, useLayoutEffect, useState } from "react";
import { useSettings } from "../../store/hooks";
import type { BarView } from "./barGeometry";
import { type BarColours, paintBar } from "./barPainter";
import { useFlightFacts, usePlayback } from "./usePlayback";

interface Size {
  readonly width: number;
  readonly height: number;
}

/** Size of an element in CSS pixels, followed. */
export function useSize(element: RefObject<HTMLElement | null>): Size {
  const [size, setSize] = useState<Size>({ width: 0, height: 0 });
  useLayoutEffect(() => {
    const box = element.current;
    if (box === null) {
      return undefined;
    }
    const look = (): void => setSize({ width: box.clientWidth, height: box.clientHeight });
    look();
    const observer = new ResizeObserver(look);
    observer.observe(box);
    return () => observer.disconnect();
  }, [element]);
  return size;
}

/** Draws the flight on the canvas, only when something of it has changed: the handle is an element of its own. */
export function useBarPicture(
  canvas: RefObject<HTMLCanvasElement | null>,
  { width, height }: Size,
  view: BarView,
  edge_s: number,
): void {
  const theme = useSettings((settings) => settings.theme);
  const overview = useFlightFacts((facts) => facts.overview);
  const events = useFlightFacts((facts) => facts.events);
  const loop = usePlayback((state) => state.loop);
  const starts_s = usePlayback((state) => state.starts_s);
  const isThin = usePlayback((state) => state.flight === null);
  // biome-ignore lint/correctness/useExhaustiveDependencies: another theme has other colours
  useEffect(() => {
    const element = canvas.current;
    const context = element?.getContext("2d") ?? null;
    if (element === null || context === null || width === 0 || height === 0) {
      return undefined;
    }
    // Not before the next animation frame: another theme is applied after the effects of what is inside of the page.
    const waiting = requestAnimationFrame(() => paint(element, context));
    return () => cancelAnimationFrame(waiting);

    function paint(element: HTMLCanvasElement, context: CanvasRenderingContext2D): void {
      const ratio = window.devicePixelRatio || 1;
      element.width = Math.round(width * ratio);
      element.height = Math.round(height * ratio);
      context.setTransform(ratio, 0, 0, ratio, 0, 0);
      const style = getComputedStyle(element);
      const fontSize_px = Number.parseFloat(style.fontSize) || 12;
      paintBar(context, {
        width,
        height,
        view,
        edge_s,
        overview,
        events,
        starts_s,
        loop,
        isThin,
        colours: coloursOf(style),
        fontSize_px,
        font: `${fontSize_px}px ${style.getPropertyValue("--font-number").trim() || "monospace"}`,
      });
    }
  }, [canvas, width, height, view, edge_s, overview, events, starts_s, loop, isThin, theme]);
}

function coloursOf(style: CSSStyleDeclaration): BarColours {
  const colour = (token: string): string => style.getPropertyValue(token).trim() || "#888888";
  return {
    ground: colour("--surface-3"),
    outline: colour("--line-control"),
    gap: colour("--text-muted"),
    tick: colour("--line"),
    text: colour("--text-muted"),
    loop: colour("--past"),
    lane: {
      command: colour("--accent"),
      mode: colour("--engaged"),
      alarm: colour("--warning"),
      waypoint: colour("--guidance"),
      mark: colour("--text"),
    },
  };
}
