import { type RefObject, useEffect, useRef, useState } from "react";
import type { Position } from "../../../lib/geodesy";
import { FlatScene } from "../../../scene/flat/FlatScene";
import { metresPerPixel } from "../../../scene/flat/projection";
import { readIslands } from "../../../scene/globe/chart/coast";

interface Listener {
  readonly onScale: (pixel_m: number) => void;
  readonly onPointer: (place: Position | null) => void;
  readonly onMoved: () => void;
}

const COASTLINE = "/map/canary-coastline.json";

/** The flat map on this canvas; null without a canvas. */
export function useFlatScene(
  canvas: RefObject<HTMLCanvasElement | null>,
  listener: Listener,
): FlatScene | null {
  const [scene, setScene] = useState<FlatScene | null>(null);
  const newest = useRef(listener);
  useEffect(() => {
    newest.current = listener;
  });
  useEffect(() => {
    if (canvas.current === null) {
      return undefined;
    }
    const made = new FlatScene(canvas.current, {
      onView: (view) => newest.current.onScale(metresPerPixel(view)),
      onPointer: (place) => newest.current.onPointer(place),
      onMoved: () => newest.current.onMoved(),
    });
    setScene(made);
    const end = new AbortController();
    fetch(COASTLINE, { signal: end.signal })
      .then(async (answer) => made.setIslands(readIslands(await answer.text())))
      // Without the coastline the map still shows the flight.
      .catch(() => undefined);
    return () => {
      end.abort();
      made.dispose();
    };
  }, [canvas]);
  return scene;
}
