import { type RefObject, useEffect } from "react";
import type { LabelBox } from "../../../lib/labels";
import type { FlatScene } from "../../../scene/flat/FlatScene";

/** What stands over the map and is read or pressed. */
const OVER = ".map-legend, .map-attribution, .map-views, .map-edit-bar, .map-figures, .map-card";

/** Tells the scene where its canvas is covered, whenever that changes in size or number. */
export function useCovered(canvas: RefObject<HTMLCanvasElement | null>, scene: FlatScene | null): void {
  useEffect(() => {
    const picture = canvas.current?.closest(".map-scene");
    if (scene === null || !(picture instanceof Element) || typeof ResizeObserver === "undefined") {
      return;
    }
    const sizes = new ResizeObserver(() => scene.setCovered(boxesIn(picture)));
    const follow = (): void => {
      sizes.disconnect();
      for (const part of [picture, ...picture.querySelectorAll(OVER)]) {
        sizes.observe(part);
      }
    };
    const parts = new MutationObserver(follow);
    parts.observe(picture, { childList: true });
    for (const over of picture.querySelectorAll(".map-over")) {
      parts.observe(over, { childList: true });
    }
    follow();
    return () => {
      sizes.disconnect();
      parts.disconnect();
    };
  }, [canvas, scene]);
}

function boxesIn(picture: Element): LabelBox[] {
  const { left, top } = picture.getBoundingClientRect();
  return [...picture.querySelectorAll(OVER)]
    .map((over) => over.getBoundingClientRect())
    .filter(({ width, height }) => width > 0 && height > 0)
    .map((box) => ({
      left: box.left - left,
      top: box.top - top,
      right: box.right - left,
      bottom: box.bottom - top,
    }));
}
