import { tellTiming } from "../../lib/timing";

/** Names by which browsers tell that no graphics processor draws. */
const SOFTWARE = /swiftshader|llvmpipe|softpipe|software|basic render/i;
/** A frame that says nothing for so long is given up: the next one may be drawn. */
const LONGEST_MS = 5000;

/** What a frame of a canvas costs, until the graphics have finished it: the page's own part is the lesser one. */
export class FrameCost {
  readonly #graphics: WebGL2RenderingContext | null;
  #started_ms = 0;
  #fence: WebGLSync | null = null;

  constructor(canvas: HTMLCanvasElement) {
    this.#graphics = canvas.getContext("webgl2");
  }

  /** Whether the browser says that the processor draws alone. */
  get isSoftware(): boolean {
    const told = this.#graphics?.getExtension("WEBGL_debug_renderer_info");
    const name: unknown = told == null ? null : this.#graphics?.getParameter(told.UNMASKED_RENDERER_WEBGL);
    return typeof name === "string" && SOFTWARE.test(name);
  }

  /** A frame is on its way. */
  get isWaiting(): boolean {
    return this.#fence !== null;
  }

  /** Returns when that is, by `performance.now()`. */
  start(): number {
    this.#started_ms = performance.now();
    return this.#started_ms;
  }

  /** All of the frame has been handed to the graphics. */
  finish(): void {
    const graphics = this.#graphics;
    this.#fence = graphics?.fenceSync(graphics.SYNC_GPU_COMMANDS_COMPLETE, 0) ?? null;
    graphics?.flush();
  }

  /** What the frame on its way has cost, milliseconds, once it is done; null while it is not. */
  settle(): number | null {
    const [graphics, fence] = [this.#graphics, this.#fence];
    if (graphics === null || fence === null) {
      return null;
    }
    const cost_ms = performance.now() - this.#started_ms;
    const isDone = graphics.getSyncParameter(fence, graphics.SYNC_STATUS) === graphics.SIGNALED;
    if (!isDone && cost_ms < LONGEST_MS && !graphics.isContextLost()) {
      return null;
    }
    graphics.deleteSync(fence);
    this.#fence = null;
    tellTiming("globe.frame", this.#started_ms);
    return cost_ms;
  }
}
