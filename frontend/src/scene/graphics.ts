import { tellTiming } from "../lib/timers";

/** Renderer names that mean "no graphics processor". */
const SOFTWARE = /swiftshader|llvmpipe|softpipe|software|basic render/i;
/** A picture that does not finish within this time is given up: the next may be drawn. */
const LONGEST_MS = 5000;

let isOffered = false;

/** Whether this browser offers WebGL. Asked before an engine is loaded, which would be useless without it. */
export function hasWebgl(): boolean {
  // Once offered, it stays so; if not, it may have been switched on since.
  if (!isOffered) {
    isOffered = ask((graphics) => graphics !== null);
  }
  return isOffered;
}

/** Whether the browser reports that it draws without a graphics processor. */
function isSoftware(graphics: WebGL2RenderingContext): boolean {
  // Without the extension, the plain name may tell.
  const told = graphics.getExtension("WEBGL_debug_renderer_info");
  const name: unknown = graphics.getParameter(told?.UNMASKED_RENDERER_WEBGL ?? graphics.RENDERER);
  return typeof name === "string" && SOFTWARE.test(name);
}

/**
 * Whether WebGL is drawn without a graphics processor. Asked where the picture must be set up differently from the
 * start.
 */
export function drawsInSoftware(): boolean {
  return ask((graphics) => graphics !== null && isSoftware(graphics));
}

/** WebGL's answer about itself; null: there is none. */
function ask(whether: (graphics: WebGL2RenderingContext | null) => boolean): boolean {
  const graphics = document.createElement("canvas").getContext("webgl2");
  const answer = whether(graphics);
  // Release the context: a browser has only some sixteen.
  graphics?.getExtension("WEBGL_lose_context")?.loseContext();
  return answer;
}

/**
 * Measures the cost of a canvas's pictures until the graphics have finished them: the page's own part is the smaller
 * one.
 */
export class PictureCost {
  readonly #graphics: WebGL2RenderingContext | null;
  readonly #timing: string;
  #started_ms = 0;
  #fence: WebGLSync | null = null;

  /** `timing`: the name of each picture's entry in the browser's performance tools. */
  constructor(graphics: WebGL2RenderingContext | null, timing: string) {
    this.#graphics = graphics;
    this.#timing = timing;
  }

  /** A picture is pending. */
  get isWaiting(): boolean {
    return this.#fence !== null;
  }

  /** Returns the start time, by `performance.now()`. */
  start(): number {
    this.#started_ms = performance.now();
    return this.#started_ms;
  }

  /** The whole picture has been handed to the graphics. */
  finish(): void {
    const graphics = this.#graphics;
    this.#fence = graphics?.fenceSync(graphics.SYNC_GPU_COMMANDS_COMPLETE, 0) ?? null;
    graphics?.flush();
  }

  /** The cost of the pending picture, milliseconds, once it is finished; null before. */
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
