import { type PerspectiveCamera, type Scene, WebGLRenderer } from "three";
import type { Drawer } from "./Stage";

const SOFTWARE = /swiftshader|llvmpipe|softpipe|software|basic render/i;
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
  readonly #context: WebGL2RenderingContext;
  readonly #renderer: WebGLRenderer;
  #fence: WebGLSync | null = null;

  constructor(canvas: HTMLCanvasElement, context: WebGL2RenderingContext) {
    this.canvas = canvas;
    this.#context = context;
    this.isSoftware = SOFTWARE.test(rendererName(context));
    this.#renderer = new WebGLRenderer({ canvas, context, antialias: true });
    this.#renderer.debug.checkShaderErrors = false;
    this.#renderer.setPixelRatio(
      this.isSoftware ? 1 : Math.min(MOST_PIXELS_PER_PIXEL, window.devicePixelRatio),
    );
  }

  isBusy(): boolean {
    if (this.#fence === null) {
      return false;
    }
    const { SYNC_STATUS, SIGNALED } = this.#context;
    if (
      !this.#context.isContextLost() &&
      this.#context.getSyncParameter(this.#fence, SYNC_STATUS) !== SIGNALED
    ) {
      return true;
    }
    this.#context.deleteSync(this.#fence);
    this.#fence = null;
    return false;
  }

  render(scene: Scene, camera: PerspectiveCamera): void {
    this.#renderer.render(scene, camera);
    this.#fence = this.#context.fenceSync(this.#context.SYNC_GPU_COMMANDS_COMPLETE, 0);
    this.#context.flush();
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

function rendererName(context: WebGL2RenderingContext): string {
  const names = context.getExtension("WEBGL_debug_renderer_info");
  const name: unknown = context.getParameter(names?.UNMASKED_RENDERER_WEBGL ?? context.RENDERER);
  return typeof name === "string" ? name : "";
}
