import type { Timers } from "../../lib/timers";

export interface ChartListener {
  readonly onZoomTo: (from_s: number, to_s: number) => void;
  readonly onZoom: (about_s: number, factor: number) => void;
  readonly onPan: (by_s: number) => void;
  readonly onAll: () => void;
  readonly onMoment: (at_s: number) => void;
  /** The moment under the pointer; null when it leaves. */
  readonly onHover: (at_s: number | null) => void;
}

interface Parts {
  /** The moment at a pixel from the left edge. */
  readonly momentAt: (x: number) => number;
  /** Seconds that the chart shows. */
  readonly span_s: () => number;
  readonly listener: ChartListener;
  readonly timers: Timers;
}

/** A hand may tremble so far in a click. */
const TREMBLE_PX = 4;
const ZOOM_PER_PIXEL = 1.0015;
/** A second click in this time makes it a double click, which does not set the moment. */
const DOUBLE_MS = 250;

/**
 * Wheel, clicks and touch on a chart; the mouse's drag is uPlot's own. One finger moves the stretch, two pinch it, and
 * a short touch sets the moment.
 */
export class ChartGestures {
  readonly #over: HTMLElement;
  readonly #parts: Parts;
  readonly #stop = new AbortController();
  readonly #fingers = new Map<number, number>();
  #pressed_x: number | null = null;
  #cancel: () => void = () => undefined;

  constructor(over: HTMLElement, parts: Parts) {
    this.#over = over;
    this.#parts = parts;
    const { signal } = this.#stop;
    over.style.touchAction = "pan-y";
    over.addEventListener("wheel", this.#wheel, { passive: false, signal });
    over.addEventListener("pointerdown", this.#down, { signal });
    over.addEventListener("pointermove", this.#move, { signal });
    over.addEventListener("pointerup", this.#up, { signal });
    over.addEventListener("pointercancel", this.#up, { signal });
  }

  /** The click that waits is part of a double click. */
  cancelClick(): void {
    this.#cancel();
  }

  end(): void {
    this.#cancel();
    this.#stop.abort();
  }

  readonly #wheel = (event: WheelEvent): void => {
    event.preventDefault();
    const { momentAt, span_s, listener } = this.#parts;
    const { left, width } = this.#over.getBoundingClientRect();
    if (event.shiftKey || Math.abs(event.deltaX) > Math.abs(event.deltaY)) {
      listener.onPan(((event.deltaX || event.deltaY) / Math.max(1, width)) * span_s());
    } else {
      listener.onZoom(momentAt(event.clientX - left), ZOOM_PER_PIXEL ** event.deltaY);
    }
  };

  readonly #down = (event: PointerEvent): void => {
    if (event.button !== 0) {
      return;
    }
    this.#pressed_x = this.#fingers.size === 0 ? event.clientX : null;
    this.#fingers.set(event.pointerId, event.clientX);
    if (event.pointerType === "touch") {
      this.#over.setPointerCapture?.(event.pointerId);
    }
  };

  readonly #move = (event: PointerEvent): void => {
    const before = this.#fingers.get(event.pointerId);
    if (before === undefined) {
      return;
    }
    if (this.#pressed_x !== null && Math.abs(event.clientX - this.#pressed_x) > TREMBLE_PX) {
      this.#pressed_x = null;
    }
    if (event.pointerType !== "touch" || this.#pressed_x !== null) {
      return;
    }
    const { momentAt, span_s, listener } = this.#parts;
    const { left, width } = this.#over.getBoundingClientRect();
    const other = [...this.#fingers].find(([id]) => id !== event.pointerId)?.[1];
    if (other === undefined) {
      listener.onPan(((before - event.clientX) / Math.max(1, width)) * span_s());
    } else {
      const apart_px = Math.max(10, Math.abs(event.clientX - other));
      const apartBefore_px = Math.max(10, Math.abs(before - other));
      listener.onZoom(momentAt((event.clientX + other) / 2 - left), apartBefore_px / apart_px);
    }
    this.#fingers.set(event.pointerId, event.clientX);
  };

  readonly #up = (event: PointerEvent): void => {
    this.#fingers.delete(event.pointerId);
    if (this.#pressed_x === null || event.type !== "pointerup") {
      return;
    }
    this.#pressed_x = null;
    this.#cancel();
    const { momentAt, listener, timers } = this.#parts;
    const at_s = momentAt(event.clientX - this.#over.getBoundingClientRect().left);
    this.#cancel = timers.after(DOUBLE_MS, () => listener.onMoment(Math.max(0, at_s)));
  };
}
