import type { PerspectiveCamera, Scene } from "three";
import type { AnimationFrames } from "../../lib/timers";
import { PictureBudget } from "../pictureBudget";
import { stageLimits } from "./stageBudget";

/** What draws: WebGL, or a test's counter. */
export interface Drawer {
  /** What is shown. */
  readonly canvas: HTMLCanvasElement;
  /** The canvas that is drawn on; it gets the events when the browser takes the context away. */
  readonly picture: EventTarget;
  /** It draws without a graphics processor. */
  readonly isSoftware: boolean;
  /** The last picture is not finished: another would only queue. */
  readonly isWaiting: boolean;
  /** Compile all that drawing needs, asynchronously like a picture. */
  prepare(scene: Scene, camera: PerspectiveCamera): void;
  /** The cost of the pending picture, milliseconds, once it is finished and shown; null before. */
  settle(): number | null;
  /** `isMoving`: it may be coarser than a resting one. */
  render(scene: Scene, camera: PerspectiveCamera, isMoving: boolean): void;
  /** In CSS pixels. */
  setSize(width: number, height: number): void;
  dispose(): void;
}

/** A scene with its camera. */
export interface Act {
  readonly scene: Scene;
  readonly camera: PerspectiveCamera;
  /** Whether it has its colours and labels: before that it is not shown. */
  readonly isDressed: boolean;
  /** Advance to this moment; returns whether it continues to change by itself. */
  advance(now_ms: number): boolean;
}

/** After this time without a change, a coarse picture is drawn once more finely. */
const REST_MS = 250;
/** For this long after the user's last movement, it counts as being turned. */
const HELD_MS = 400;

/**
 * One canvas and one WebGL context for the page's whole life, moved to where they are shown. It draws when something
 * has changed, and while that changes by itself; else it requests no animation frame.
 */
export class Stage {
  readonly #drawer: Drawer;
  readonly #animationFrames: AnimationFrames;
  readonly #watch: ResizeObserver | null;
  #act: Act | null = null;
  /** The act shown now or last. */
  #latest: Act | null = null;
  #host: HTMLElement | null = null;
  #handle: number | null = null;
  readonly #budget: PictureBudget;
  #prepared = new WeakSet<Act>();
  #isDirty = false;
  #isCoarse = false;
  #isLost = false;
  #drawn = 0;
  #drawn_ms = Number.NEGATIVE_INFINITY;
  #held_ms = Number.NEGATIVE_INFINITY;

  /** Called when the browser takes the context away (true) and gives it back. */
  onLost: ((isLost: boolean) => void) | null = null;

  constructor(drawer: Drawer, animationFrames: AnimationFrames) {
    this.#drawer = drawer;
    this.#animationFrames = animationFrames;
    this.#watch = typeof ResizeObserver === "undefined" ? null : new ResizeObserver(() => this.#resize());
    this.#budget = new PictureBudget(drawer.isSoftware, stageLimits(drawer.isSoftware));
    drawer.picture.addEventListener("webglcontextlost", this.#lose);
    drawer.picture.addEventListener("webglcontextrestored", this.#restore);
  }

  /** Number of pictures drawn. */
  get drawn(): number {
    return this.#drawn;
  }

  get isLost(): boolean {
    return this.#isLost;
  }

  /** Show this act in this element. */
  show(act: Act, host: HTMLElement): void {
    if (act !== this.#latest) {
      // Until this act is drawn, the canvas shows the one before.
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

  /** Show nothing: the canvas is kept outside the document and costs nothing. */
  hide(): void {
    this.#act = null;
    this.#host = null;
    this.#watch?.disconnect();
    this.#drawer.canvas.remove();
    this.#rest();
  }

  /** Request a new picture. */
  invalidate(): void {
    this.#isDirty = true;
    this.#wake();
  }

  /** The user turned it at `now_ms` of the animation frames: for a moment it may be drawn more often. */
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
      this.#handle ??= this.#animationFrames.request(this.#animate);
    }
  }

  #rest(): void {
    if (this.#handle !== null) {
      this.#animationFrames.cancel(this.#handle);
      this.#handle = null;
    }
  }

  readonly #animate = (now_ms: number): void => {
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
      // It is requested again once it is dressed.
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
    // Without this the browser never restores the context.
    event.preventDefault();
    this.#isLost = true;
    // The pending picture will never be finished.
    this.#drawer.settle();
    this.#rest();
    this.onLost?.(true);
  };

  readonly #restore = (): void => {
    this.#isLost = false;
    // The resources of the old context are lost.
    this.#prepared = new WeakSet();
    this.onLost?.(false);
    this.invalidate();
  };
}
