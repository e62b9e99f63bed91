import { type PerspectiveCamera, type Scene, WebGLRenderer } from "three";
import { FrameCost, isSoftware } from "../graphics";
import type { Drawer } from "./Stage";

/** Sharper than this nobody sees, and it costs by the square. */
const MOST_PIXELS_PER_PIXEL = 2;

/** WebGL on a canvas of its own; null where the browser has none. */
export function webglDrawer(): Drawer | null {
  const canvas = document.createElement("canvas");
  // Asked for here and not by the renderer, which would write to the console where there is none.
  const context = canvas.getContext("webgl2", {
    antialias: true,
    alpha: false,
    powerPreference: "low-power",
  });
  return context === null ? null : new WebglDrawer(canvas, context);
}

class WebglDrawer implements Drawer {
  readonly canvas: HTMLCanvasElement;
  readonly isSoftware: boolean;
  readonly #cost: FrameCost;
  readonly #renderer: WebGLRenderer;

  constructor(canvas: HTMLCanvasElement, context: WebGL2RenderingContext) {
    this.canvas = canvas;
    this.isSoftware = isSoftware(context);
    this.#cost = new FrameCost(context, "attitude.frame");
    this.#renderer = new WebGLRenderer({ canvas, context, antialias: true });
    this.#renderer.debug.checkShaderErrors = false;
    this.#renderer.setPixelRatio(
      this.isSoftware ? 1 : Math.min(MOST_PIXELS_PER_PIXEL, window.devicePixelRatio),
    );
  }

  isBusy(): boolean {
    this.#cost.settle();
    return this.#cost.isWaiting;
  }

  render(scene: Scene, camera: PerspectiveCamera): void {
    this.#cost.start();
    this.#renderer.render(scene, camera);
    this.#cost.finish();
  }

  setSize(width: number, height: number): void {
    this.#renderer.setSize(width, height);
  }

  dispose(): void {
    this.#renderer.dispose();
    // A browser has some sixteen contexts, and takes the oldest away when they are used up.
    this.#renderer.forceContextLoss();
  }
}
