import { type PerspectiveCamera, type Scene, WebGLRenderer } from "three";
import { CopiedPicture } from "../CopiedPicture";
import { drawsInSoftware, PictureCost } from "../graphics";
import type { Drawer } from "./Stage";
import { softwareRatio } from "./stageBudget";

/** A higher resolution is not visible, and the cost grows with its square. */
const MOST_PIXELS_PER_PIXEL = 2;

/** WebGL on its own canvas; null if the browser has none. */
export function webglDrawer(): Drawer | null {
  const isSoftware = drawsInSoftware();
  const picture = document.createElement("canvas");
  // Requested here and not by the renderer, which would write to the console on failure.
  const context = picture.getContext("webgl2", {
    alpha: false,
    powerPreference: "low-power",
    antialias: !isSoftware,
    // Kept until it is copied, long after it was drawn.
    preserveDrawingBuffer: isSoftware,
  });
  return context === null
    ? null
    : new WebglDrawer(picture, context, isSoftware ? new CopiedPicture(picture) : null);
}

class WebglDrawer implements Drawer {
  readonly canvas: HTMLCanvasElement;
  readonly picture: HTMLCanvasElement;
  readonly isSoftware: boolean;
  readonly #copied: CopiedPicture | null;
  readonly #cost: PictureCost;
  readonly #renderer: WebGLRenderer;
  /** Whether the pending work is a picture, not a preparation. */
  #isDrawn = false;
  #width = 1;
  #height = 1;

  /** `copied`: shown instead of a picture drawn without a graphics processor. */
  constructor(picture: HTMLCanvasElement, context: WebGL2RenderingContext, copied: CopiedPicture | null) {
    this.picture = picture;
    this.canvas = copied?.canvas ?? picture;
    this.isSoftware = copied !== null;
    this.#copied = copied;
    this.#cost = new PictureCost(context, "attitude.picture");
    this.#renderer = new WebGLRenderer({ canvas: picture, context });
    this.#renderer.debug.checkShaderErrors = false;
    this.#renderer.setPixelRatio(Math.min(MOST_PIXELS_PER_PIXEL, window.devicePixelRatio));
  }

  get isWaiting(): boolean {
    return this.#cost.isWaiting;
  }

  prepare(scene: Scene, camera: PerspectiveCamera): void {
    this.#isDrawn = false;
    this.#cost.start();
    this.#renderer.compile(scene, camera);
    this.#cost.finish();
  }

  settle(): number | null {
    const cost_ms = this.#cost.settle();
    if (cost_ms === null || !this.#isDrawn) {
      return null;
    }
    this.#copied?.copy();
    return cost_ms;
  }

  render(scene: Scene, camera: PerspectiveCamera, isMoving: boolean): void {
    if (this.isSoftware) {
      this.#suit(softwareRatio(this.#width, this.#height, isMoving));
    }
    this.#isDrawn = true;
    this.#cost.start();
    this.#renderer.render(scene, camera);
    this.#cost.finish();
  }

  setSize(width: number, height: number): void {
    [this.#width, this.#height] = [width, height];
    if (this.#copied === null) {
      this.#renderer.setSize(width, height);
    } else {
      this.canvas.style.width = `${width}px`;
      this.canvas.style.height = `${height}px`;
    }
  }

  dispose(): void {
    this.#renderer.dispose();
    // A browser has some sixteen contexts, and takes the oldest away when all are in use.
    this.#renderer.forceContextLoss();
  }

  /** Both at once: each alone would allocate the buffers again. */
  #suit(ratio: number): void {
    const { width, height } = this.picture;
    if (width !== Math.floor(this.#width * ratio) || height !== Math.floor(this.#height * ratio)) {
      this.#renderer.setDrawingBufferSize(this.#width, this.#height, ratio);
    }
  }
}
