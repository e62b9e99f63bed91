import { crossingSides } from "../../lib/fenceBorder";
import type { Position } from "../../lib/geodesy";
import { FENCE, WARNED } from "../colours";
import { nearest } from "../legs/geometry";
import type { Grip } from "../tools/MapPointer";
import { drawDistance, type MarkedPlace } from "./flatThings";
import { drawLine } from "./ink";
import { type FlatView, fromScreen, type ScreenPoint, toScreen } from "./projection";
import type { Words } from "./Words";

/** Told where a corner was put; null: the fence cannot be changed now. */
export type FenceListener = ((corner: number, to: Position) => void) | null;

/** The fence on the flat map, whose corners can be dragged and whose crossing sides are marked, and where the present track leads while that is warned of. */
export class FlatFence {
  readonly #onChange: () => void;
  #corners: readonly Position[] = [];
  #isSaved = true;
  #warned: ReadonlyArray<readonly MarkedPlace[]> = [];
  #listener: FenceListener = null;
  #held: { readonly corner: number; readonly to: Position } | null = null;

  constructor(onChange: () => void) {
    this.#onChange = onChange;
  }

  listen(listener: FenceListener): void {
    this.#listener = listener;
  }

  /** `isSaved`: the station watches it as it is drawn; else its line is dashed. */
  show(corners: readonly Position[], isSaved: boolean): void {
    this.#corners = corners;
    this.#isSaved = isSaved;
    this.#onChange();
  }

  /** The present tracks that are warned of, each to what it leads to. */
  warn(tracks: ReadonlyArray<readonly MarkedPlace[]>): void {
    this.#warned = tracks;
    this.#onChange();
  }

  draw(context: CanvasRenderingContext2D, view: FlatView, words: Words): void {
    const corners = this.#shown();
    const border = corners.length > 2 ? [...corners, ...corners.slice(0, 1)] : corners;
    const isDashed = !this.#isSaved || this.#held !== null;
    drawLine(
      context,
      border.map((place) => toScreen(view, place)),
      { colour: FENCE, width_px: 3, isDashed },
    );
    for (const side of crossingSides(corners) ?? []) {
      drawLine(
        context,
        border.slice(side, side + 2).map((place) => toScreen(view, place)),
        { colour: WARNED, width_px: 5 },
      );
    }
    if (this.#listener !== null || !this.#isSaved) {
      for (const corner of corners) {
        drawDistance(context, view, [{ ...corner, label: "" }], words, FENCE);
      }
    }
    for (const track of this.#warned) {
      drawLine(
        context,
        track.map((place) => toScreen(view, place)),
        { colour: WARNED, width_px: 4 },
      );
      drawDistance(context, view, track.slice(-1), words, WARNED);
    }
  }

  /** The corner that can be taken hold of at this place of the view. */
  find(view: () => FlatView, at: ScreenPoint, reach_px: number): Grip | null {
    const listener = this.#listener;
    const spots = this.#corners.map((corner) => toScreen(view(), corner));
    const corner = listener === null ? null : nearest(spots, at, reach_px);
    const start = corner === null ? undefined : spots[corner];
    if (listener === null || corner === null || start === undefined) {
      return null;
    }
    const hold = (to: Position | null): void => {
      this.#held = to === null ? null : { corner, to };
      this.#onChange();
    };
    return {
      cursor: "grab",
      click: () => undefined,
      drag: (from) => ({
        move: (now) => hold(fromScreen(view(), { x: start.x + now.x - from.x, y: start.y + now.y - from.y })),
        drop: () => {
          const to = this.#held?.to;
          hold(null);
          if (to !== undefined) {
            listener(corner, to);
          }
        },
        cancel: () => hold(null),
      }),
    };
  }

  #shown(): readonly Position[] {
    const held = this.#held;
    return held === null ? this.#corners : this.#corners.with(held.corner, held.to);
  }
}
