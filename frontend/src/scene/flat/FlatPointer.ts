import { REACH_PX, reachOf } from "../legs/target";
import { type GestureHands, Gestures } from "../tools/Gestures";
import type { Drag, Grip } from "../tools/MapPointer";
import type { ScreenPoint } from "./projection";

/** What the pointer finds and moves. */
export interface FlatHands extends GestureHands {
  /** What can be taken hold of within so many pixels; taps are for what lies under nothing of that kind. */
  readonly find: (at: ScreenPoint, reach_px: number) => Grip | null;
  /** The pointer's look over bare ground; "": the usual one. */
  readonly cursor: () => string;
  readonly pan: (right_px: number, down_px: number) => void;
  /** Larger by so many steps of two, about this place. */
  readonly zoom: (steps: number, at: ScreenPoint) => void;
  /** Null: the pointer is not over the map. */
  readonly hover: (at: ScreenPoint | null) => void;
}

/** Nearer than this to where it went down, pixels, the pointer has been pressed and not pulled. */
const CLICK_PX = 4;
const WHEEL_STEP = 1 / 400;
/** Neither smaller nor larger at once, however far a wheel was turned. */
const WHEEL_MOST = 1;

/** Mouse, pen and fingers on the flat map: press, pull a thing, push the map, turn the wheel, spread two fingers. */
export class FlatPointer {
  readonly #canvas: HTMLCanvasElement;
  readonly #hands: FlatHands;
  readonly #end = new AbortController();
  readonly #gestures: Gestures;
  /** Where each pointer that is down is now. */
  readonly #down = new Map<number, ScreenPoint>();
  #pressed: ScreenPoint | null = null;
  #grip: Grip | null = null;
  #drag: Drag | null = null;

  constructor(canvas: HTMLCanvasElement, hands: FlatHands) {
    this.#canvas = canvas;
    this.#hands = hands;
    const { signal } = this.#end;
    this.#gestures = new Gestures(canvas, {
      tap: (at) => hands.find(at, REACH_PX.mouse) === null && hands.tap(at),
      double: (at) => hands.find(at, REACH_PX.mouse) === null && hands.double(at),
      menu: (at, isFinger) => {
        this.#letGo((drag) => drag.cancel());
        // A finger that still rests on the map must not push it.
        this.#down.clear();
        hands.menu(at, isFinger);
      },
    });
    canvas.addEventListener("pointerdown", (event) => this.#press(event), { signal });
    canvas.addEventListener("pointermove", (event) => this.#move(event), { signal });
    canvas.addEventListener("pointerup", (event) => this.#lift(event), { signal });
    canvas.addEventListener("pointercancel", (event) => this.#cancel(event), { signal });
    canvas.addEventListener("pointerleave", () => hands.hover(null), { signal });
    canvas.addEventListener("wheel", (event) => this.#wheel(event), { signal, passive: false });
    window.addEventListener("keydown", (event) => this.#key(event), { signal, capture: true });
  }

  dispose(): void {
    this.#end.abort();
    this.#gestures.dispose();
    this.#letGo((drag) => drag.cancel());
  }

  #press(event: PointerEvent): void {
    const at = spotOf(event);
    this.#down.set(event.pointerId, at);
    this.#canvas.setPointerCapture(event.pointerId);
    // A second finger spreads the map: nothing is pulled any more.
    this.#letGo((drag) => drag.cancel());
    if (event.button === 0 && this.#down.size === 1) {
      this.#pressed = at;
      this.#grip = this.#hands.find(at, reachOf(event.pointerType));
    }
  }

  #move(event: PointerEvent): void {
    const at = spotOf(event);
    const before = this.#down.get(event.pointerId);
    if (before === undefined) {
      this.#canvas.style.cursor = this.#hands.find(at, REACH_PX.mouse)?.cursor ?? this.#hands.cursor();
    } else if (this.#down.size > 1) {
      this.#spread(event.pointerId, before, at);
    } else {
      this.#pull(before, at, event.shiftKey);
    }
    if (before !== undefined) {
      this.#down.set(event.pointerId, at);
    }
    this.#hands.hover(at);
  }

  #pull(before: ScreenPoint, at: ScreenPoint, isShift: boolean): void {
    if (this.#pressed !== null && away(at, this.#pressed) <= CLICK_PX) {
      return;
    }
    const from = this.#pressed ?? before;
    this.#pressed = null;
    this.#drag ??= this.#grip?.drag?.(from, isShift) ?? null;
    if (this.#drag === null) {
      this.#hands.pan(from.x - at.x, from.y - at.y);
    } else {
      this.#drag.move(at, isShift);
    }
  }

  #spread(pointer: number, before: ScreenPoint, at: ScreenPoint): void {
    const other = [...this.#down].find(([id]) => id !== pointer)?.[1];
    if (other !== undefined) {
      const middle = { x: (at.x + other.x) / 2, y: (at.y + other.y) / 2 };
      this.#hands.pan((before.x - at.x) / 2, (before.y - at.y) / 2);
      this.#hands.zoom(Math.log2(away(at, other) / Math.max(1, away(before, other))), middle);
    }
  }

  #lift(event: PointerEvent): void {
    const grip = this.#pressed === null ? null : this.#grip;
    this.#down.delete(event.pointerId);
    this.#letGo((drag) => drag.drop());
    grip?.click(event.shiftKey || event.ctrlKey || event.metaKey);
  }

  #cancel(event: PointerEvent): void {
    this.#down.delete(event.pointerId);
    this.#letGo((drag) => drag.cancel());
  }

  #wheel(event: WheelEvent): void {
    event.preventDefault();
    const steps = Math.max(-WHEEL_MOST, Math.min(WHEEL_MOST, -event.deltaY * WHEEL_STEP));
    this.#hands.zoom(steps, spotOf(event));
  }

  #key(event: KeyboardEvent): void {
    if (event.key === "Escape" && this.#drag !== null) {
      event.stopImmediatePropagation();
      this.#letGo((drag) => drag.cancel());
      // The button is still held down: until it is released, the pointer must not push the map instead.
      this.#down.clear();
    }
  }

  #letGo(how: (drag: Drag) => void): void {
    const drag = this.#drag;
    this.#drag = null;
    this.#grip = null;
    this.#pressed = null;
    if (drag !== null) {
      how(drag);
    }
  }
}

function spotOf({ offsetX, offsetY }: MouseEvent): ScreenPoint {
  return { x: offsetX, y: offsetY };
}

function away(one: ScreenPoint, other: ScreenPoint): number {
  return Math.hypot(one.x - other.x, one.y - other.y);
}
