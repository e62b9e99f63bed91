import type { Spot } from "../legs/geometry";

/** What a person does at one spot of a map, without pulling anything. */
export interface GestureHands {
  /** A short press of the main button, of a pen or of one finger. */
  readonly tap: (at: Spot) => void;
  /** The second of two taps at the same spot; the first was a tap. */
  readonly double: (at: Spot) => void;
  /** The other button, or a finger or pen that rests; what it holds must be let go. */
  readonly menu: (at: Spot, isFinger: boolean) => void;
}

/** A finger or pen that rests for so long asks for the menu. */
export const LONG_PRESS_MS = 500;
/** Two taps within this time and distance are one double tap. */
const DOUBLE_MS = 400;
/** Movement up to this many pixels is no movement. A finger is less steady than a mouse. */
const STEADY_PX = { mouse: 4, touch: 12 } as const;

interface Press {
  readonly at: Spot;
  readonly button: number;
  readonly reach_px: number;
}

/** Recognises taps, double taps and long presses on a canvas, beside whatever turns or pushes the map. */
export class Gestures {
  readonly #hands: GestureHands;
  readonly #end = new AbortController();
  readonly #down = new Set<number>();
  #press: Press | null = null;
  #rest: ReturnType<typeof setTimeout> | null = null;
  #last: { readonly at: Spot; readonly time_ms: number } | null = null;

  constructor(canvas: HTMLCanvasElement, hands: GestureHands) {
    this.#hands = hands;
    const options = { signal: this.#end.signal, capture: true };
    canvas.addEventListener("pointerdown", (event) => this.#begin(event), options);
    canvas.addEventListener("pointermove", (event) => this.#move(event), options);
    canvas.addEventListener("pointerup", (event) => this.#lift(event), options);
    canvas.addEventListener("pointercancel", (event) => this.#cancel(event), options);
    // The page's own menu takes its place.
    canvas.addEventListener("contextmenu", (event) => event.preventDefault(), options);
  }

  dispose(): void {
    this.#forget();
    this.#end.abort();
  }

  #begin(event: PointerEvent): void {
    if (event.isPrimary) {
      this.#down.clear();
    }
    this.#down.add(event.pointerId);
    this.#forget();
    // Two fingers turn or spread the map.
    if (this.#down.size > 1 || (event.button !== 0 && event.button !== 2)) {
      return;
    }
    const at = spotOf(event);
    const isMouse = event.pointerType === "mouse";
    this.#press = { at, button: event.button, reach_px: isMouse ? STEADY_PX.mouse : STEADY_PX.touch };
    if (!isMouse && event.button === 0) {
      this.#rest = setTimeout(() => {
        this.#forget();
        this.#last = null;
        this.#hands.menu(at, true);
      }, LONG_PRESS_MS);
    }
  }

  #move(event: PointerEvent): void {
    if (this.#press !== null && away(spotOf(event), this.#press.at) > this.#press.reach_px) {
      this.#forget();
    }
  }

  #lift(event: PointerEvent): void {
    this.#down.delete(event.pointerId);
    const press = this.#press;
    this.#forget();
    if (press === null || event.button !== press.button) {
      return;
    }
    const { at, button, reach_px } = press;
    const before = this.#last;
    this.#last = null;
    if (button === 2) {
      this.#hands.menu(at, false);
    } else if (
      before !== null &&
      event.timeStamp - before.time_ms <= DOUBLE_MS &&
      away(at, before.at) <= 2 * reach_px
    ) {
      this.#hands.double(at);
    } else {
      this.#last = { at, time_ms: event.timeStamp };
      this.#hands.tap(at);
    }
  }

  #cancel(event: PointerEvent): void {
    this.#down.delete(event.pointerId);
    this.#forget();
  }

  #forget(): void {
    this.#press = null;
    if (this.#rest !== null) {
      clearTimeout(this.#rest);
      this.#rest = null;
    }
  }
}

function spotOf({ offsetX, offsetY }: PointerEvent): Spot {
  return { x: offsetX, y: offsetY };
}

function away(one: Spot, other: Spot): number {
  return Math.hypot(one.x - other.x, one.y - other.y);
}
