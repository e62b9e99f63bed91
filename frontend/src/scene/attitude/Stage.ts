import type { PerspectiveCamera, Scene } from "three";
import { FrameBudget } from "../frameBudget";
import { stageLimits } from "./stageBudget";

/** What really draws: WebGL, or a test's counter. */
export interface Drawer {
  /** What is shown. */
  readonly canvas: HTMLCanvasElement;
  /** What is drawn on, and told when the browser takes it away. */
  readonly picture: EventTarget;
  /** The processor draws, without a graphics processor. */
  readonly isSoftware: boolean;
  /** The last frame is not finished: another one now would only queue. */
  readonly isWaiting: boolean;
  /** Have all made that drawing needs: on its way like a frame, while the page goes on. */
  prepare(scene: Scene, camera: PerspectiveCamera): void;
  /** What the frame on its way has cost, milliseconds, once it is done and shown; null while it is not. */
  settle(): number | null;
  /** `isMoving`: it need not be as fine as one that stays. */
  render(scene: Scene, camera: PerspectiveCamera, isMoving: boolean): void;
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
  /** It has its colours and words: before that there is nothing to show. */
  readonly isDressed: boolean;
  /** Bring everything to this moment; true as long as it goes on changing by itself. */
  advance(now_ms: number): boolean;
}

/** After so long without a change a picture drawn coarsely is drawn once more, finely. */
const REST_MS = 250;
/** After a person has turned it, it is in a hand for so long. */
const HELD_MS = 400;

/**
 * One canvas and one WebGL context for as long as the page lives, moved to where it is shown. Draws when something said
 * that it changed, and while that goes on changing by itself; else it asks for no frame at all.
 */
export class Stage {
  readonly #drawer: Drawer;
  readonly #frames: FrameClock;
  readonly #watch: ResizeObserver | null;
  #act: Act | null = null;
  /** Shown now, or until it was hidden. */
  #latest: Act | null = null;
  #host: HTMLElement | null = null;
  #handle: number | null = null;
  readonly #budget: FrameBudget;
  #prepared = new WeakSet<Act>();
  #isDirty = false;
  #isCoarse = false;
  #isLost = false;
  #drawn = 0;
  #drawn_ms = Number.NEGATIVE_INFINITY;
  #held_ms = Number.NEGATIVE_INFINITY;

  /** Told when the browser takes the picture away (true) and gives it back. */
  onLost: ((isLost: boolean) => void) | null = null;

  constructor(drawer: Drawer, frames: FrameClock) {
    this.#drawer = drawer;
    this.#frames = frames;
    this.#watch = typeof ResizeObserver === "undefined" ? null : new ResizeObserver(() => this.#resize());
    this.#budget = new FrameBudget(drawer.isSoftware, stageLimits(drawer.isSoftware));
    drawer.picture.addEventListener("webglcontextlost", this.#lose);
    drawer.picture.addEventListener("webglcontextrestored", this.#restore);
  }

  /** Frames drawn since it was made. */
  get drawn(): number {
    return this.#drawn;
  }

  get isLost(): boolean {
    return this.#isLost;
  }

  /** Show this act in this element. */
  show(act: Act, host: HTMLElement): void {
    if (act !== this.#latest) {
      // Until this one is drawn, the canvas still holds the one before.
      this.#drawer.canvas.style.visibility = "hidden";
      this.#latest = act;
    }
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

  /** A person turned it, at `now_ms` of the displayed frames: for a moment it may be drawn more often. */
  turn(now_ms: number): void {
    this.#held_ms = now_ms;
    this.invalidate();
  }

  dispose(): void {
    this.hide();
    this.#drawer.picture.removeEventListener("webglcontextlost", this.#lose);
    this.#drawer.picture.removeEventListener("webglcontextrestored", this.#restore);
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

  readonly #frame = (now_ms: number): void => {
    this.#handle = null;
    const act = this.#act;
    if (act === null || this.#isLost) {
      return;
    }
    const cost_ms = this.#drawer.settle();
    if (cost_ms !== null) {
      this.#budget.observe(cost_ms);
      this.#drawer.canvas.style.visibility = "";
    }
    if (!act.isDressed) {
      // Whoever dresses it says so.
      return;
    }
    this.#draw(act, now_ms);
    if (this.#isDirty || this.#isCoarse || this.#drawer.isWaiting) {
      this.#wake();
    }
  };

  #draw(act: Act, now_ms: number): void {
    if (!this.#prepared.has(act)) {
      this.#prepared.add(act);
      this.#drawer.prepare(act.scene, act.camera);
    }
    if (this.#drawer.isWaiting) {
      return;
    }
    const period_ms = this.#budget.period_ms(now_ms - this.#held_ms < HELD_MS);
    if (this.#isDirty && now_ms - this.#drawn_ms >= period_ms) {
      this.#isDirty = act.advance(now_ms);
      this.#isCoarse = this.#drawer.isSoftware;
      this.#render(act, now_ms);
    } else if (this.#isCoarse && !this.#isDirty && now_ms - this.#drawn_ms >= REST_MS) {
      this.#isCoarse = false;
      this.#render(act, now_ms);
    }
  }

  #render(act: Act, now_ms: number): void {
    this.#drawer.render(act.scene, act.camera, this.#isCoarse);
    this.#drawn += 1;
    this.#drawn_ms = now_ms;
  }

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
    // A frame on its way will never be done.
    this.#drawer.settle();
    this.#rest();
    this.onLost?.(true);
  };

  readonly #restore = (): void => {
    this.#isLost = false;
    // What was made for the picture before is not there any more.
    this.#prepared = new WeakSet();
    this.onLost?.(false);
    this.invalidate();
  };
}
