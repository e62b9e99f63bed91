import { type RefObject, useEffect, useRef, useState } from "react";
import type { PickedAirfield } from "../../../lib/aircraft";
import type { Position } from "../../../lib/geodesy";
import { FlatScene } from "../../../scene/flat/FlatScene";
import { metresPerPixel } from "../../../scene/flat/projection";
import { keptWorld } from "../../../scene/world/World";

interface Listener {
  readonly onScale: (pixel_m: number) => void;
  readonly onPointer: (place: Position | null) => void;
  readonly onMoved: () => void;
  readonly onAirfield: (picked: PickedAirfield) => void;
}

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
    const made = new FlatScene(canvas.current, keptWorld(), {
      onView: (view) => newest.current.onScale(metresPerPixel(view)),
      onPointer: (place) => newest.current.onPointer(place),
      onMoved: () => newest.current.onMoved(),
      onAirfield: (picked) => newest.current.onAirfield(picked),
    });
    setScene(made);
    return () => {
      made.dispose();
    };
  }, [canvas]);
  return scene;
}
