import type { PerspectiveCamera, Scene } from "three";

/** What really draws: WebGL, or a test's counter. */
export interface Drawer {
  readonly canvas: HTMLCanvasElement;
  /** The processor draws, without a graphics card. */
  readonly isSoftware: boolean;
  /** The last frame is not finished: another one now would only queue. */
  isBusy(): boolean;
  render(scene: Scene, camera: PerspectiveCamera): void;
  /** In CSS pixels. */
  setSize(width: number, height: number): void;
  dispose(): void;
}

/** Where displayed frames come from: the browser's, or a test's. */
export interface FrameClock {
  request(callback: (now_ms: number) => void): number;
  cancel(handle: number): void;
}

/** What is shown: a scene with its camera. */
export interface Act {
  readonly scene: Scene;
  readonly camera: PerspectiveCamera;
  /** Bring everything to this moment; true as long as it goes on changing by itself. */
  advance(now_ms: number): boolean;
}

/** Drawn by the processor alone: thirty times a second at the most, and no more than half of its time. */
const SOFTWARE_PERIOD_MS = 1000 / 30 - 4;
const LONGEST_PERIOD_MS = 250;
const WEIGHT = 0.2;

/**
 * One canvas and one WebGL context for as long as the page lives, moved to where it is shown. Draws when something said
 * that it changed, and while that goes on changing by itself; else it asks for no frame at all.
 */
export class Stage {
  readonly #drawer: Drawer;
  readonly #frames: FrameClock;
  readonly #watch: ResizeObserver | null;
  #act: Act | null = null;
  #host: HTMLElement | null = null;
  #handle: number | null = null;
  #isDirty = false;
  #isLost = false;
  #drawn = 0;
  #drawn_ms = Number.NEGATIVE_INFINITY;
  #isMeasuring = false;
  #cost_ms = 0;

  /** Told when the browser takes the picture away (true) and gives it back. */
  onLost: ((isLost: boolean) => void) | null = null;

  constructor(drawer: Drawer, frames: FrameClock) {
    this.#drawer = drawer;
    this.#frames = frames;
    this.#watch = typeof ResizeObserver === "undefined" ? null : new ResizeObserver(() => this.#resize());
    drawer.canvas.addEventListener("webglcontextlost", this.#lose);
    drawer.canvas.addEventListener("webglcontextrestored", this.#restore);
  }

  /** Frames drawn since it was made. */
  get drawn(): number {
    return this.#drawn;
  }

  get isLost(): boolean {
    return this.#isLost;
  }

  get isSoftware(): boolean {
    return this.#drawer.isSoftware;
  }

  /** Show this act in this element. */
  show(act: Act, host: HTMLElement): void {
    this.#act = act;
    if (this.#host !== host) {
      this.#watch?.disconnect();
      this.#host = host;
      host.append(this.#drawer.canvas);
      this.#watch?.observe(host);
    }
    this.#resize();
  }

  /** Nothing is shown: the canvas is kept, out of the document, and costs nothing. */
  hide(): void {
    this.#act = null;
    this.#host = null;
    this.#watch?.disconnect();
    this.#drawer.canvas.remove();
    this.#rest();
  }

  /** Something changed. */
  invalidate(): void {
    this.#isDirty = true;
    this.#wake();
  }

  dispose(): void {
    this.hide();
    this.#drawer.canvas.removeEventListener("webglcontextlost", this.#lose);
    this.#drawer.canvas.removeEventListener("webglcontextrestored", this.#restore);
    this.#drawer.dispose();
  }

  #wake(): void {
    if (this.#act !== null && !this.#isLost) {
      this.#handle ??= this.#frames.request(this.#frame);
    }
  }

  #rest(): void {
    if (this.#handle !== null) {
      this.#frames.cancel(this.#handle);
      this.#handle = null;
    }
  }

  get #period_ms(): number {
    return this.#drawer.isSoftware
      ? Math.min(LONGEST_PERIOD_MS, Math.max(SOFTWARE_PERIOD_MS, 2 * this.#cost_ms))
      : 0;
  }

  readonly #frame = (now_ms: number): void => {
    this.#handle = null;
    const act = this.#act;
    if (act === null || this.#isLost) {
      return;
    }
    const isBusy = this.#drawer.isBusy();
    if (this.#isMeasuring && !isBusy) {
      this.#isMeasuring = false;
      this.#cost_ms += WEIGHT * (now_ms - this.#drawn_ms - this.#cost_ms);
    }
    if (this.#isDirty && !isBusy && now_ms - this.#drawn_ms >= this.#period_ms) {
      this.#isDirty = act.advance(now_ms);
      this.#drawer.render(act.scene, act.camera);
      this.#drawn += 1;
      this.#drawn_ms = now_ms;
      this.#isMeasuring = this.#drawer.isSoftware;
    }
    if (this.#isDirty || this.#isMeasuring) {
      this.#wake();
    }
  };

  #resize(): void {
    const host = this.#host;
    if (host === null) {
      return;
    }
    const width = Math.max(1, host.clientWidth);
    const height = Math.max(1, host.clientHeight);
    this.#drawer.setSize(width, height);
    if (this.#act !== null) {
      this.#act.camera.aspect = width / height;
      this.#act.camera.updateProjectionMatrix();
    }
    this.invalidate();
  }

  readonly #lose = (event: Event): void => {
    // Without this the browser would never give it back.
    event.preventDefault();
    this.#isLost = true;
    this.#rest();
    this.onLost?.(true);
  };

  readonly #restore = (): void => {
    this.#isLost = false;
    this.#isMeasuring = false;
    this.onLost?.(false);
    this.invalidate();
  };
}
