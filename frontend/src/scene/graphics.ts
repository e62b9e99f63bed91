import { tellTiming } from "../lib/timing";

/** Names by which browsers tell that no graphics processor draws. */
const SOFTWARE = /swiftshader|llvmpipe|softpipe|software|basic render/i;
/** A frame that says nothing for so long is given up: the next one may be drawn. */
const LONGEST_MS = 5000;

let isOffered = false;

/** Whether this browser offers WebGL. Asked before an engine is fetched, which is in vain without. */
export function hasWebgl(): boolean {
  // What was offered once stays; what was not may have been switched on meanwhile.
  if (!isOffered) {
    isOffered = ask((graphics) => graphics !== null);
  }
  return isOffered;
}

/** Whether the browser says that the processor draws alone, without a graphics processor. */
function isSoftware(graphics: WebGL2RenderingContext): boolean {
  // Where the extension is not offered, the plain name may say as much.
  const told = graphics.getExtension("WEBGL_debug_renderer_info");
  const name: unknown = graphics.getParameter(told?.UNMASKED_RENDERER_WEBGL ?? graphics.RENDERER);
  return typeof name === "string" && SOFTWARE.test(name);
}

/** Whether WebGL is drawn by the processor alone. Asked where a picture must be made otherwise for it from the beginning. */
export function drawsInSoftware(): boolean {
  return ask((graphics) => graphics !== null && isSoftware(graphics));
}

/** What WebGL says of itself here; null: there is none. */
function ask(whether: (graphics: WebGL2RenderingContext | null) => boolean): boolean {
  const graphics = document.createElement("canvas").getContext("webgl2");
  const answer = whether(graphics);
  // A browser has some sixteen contexts, and this one is not needed any more.
  graphics?.getExtension("WEBGL_lose_context")?.loseContext();
  return answer;
}

/** What the frames of a canvas cost, until the graphics have finished them: the page's own part is the lesser one. */
export class FrameCost {
  readonly #graphics: WebGL2RenderingContext | null;
  readonly #timing: string;
  #started_ms = 0;
  #fence: WebGLSync | null = null;

  /** `timing`: the name under which the browser's tools are told of each frame. */
  constructor(graphics: WebGL2RenderingContext | null, timing: string) {
    this.#graphics = graphics;
    this.#timing = timing;
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
    tellTiming(this.#timing, this.#started_ms);
    return cost_ms;
  }
}
