import { NUMBER_PERIOD_MS, Pace } from "../lib/pace";
import { RedrawBudget } from "./paintBudget";

/** Where displayed frames come from: the browser's, or a test's. */
export interface FrameSource {
  readonly request: (callback: (now_ms: number) => void) => number;
  readonly cancel: (handle: number) => void;
  /** Called inside a frame: tells once what the page has spent on it, in milliseconds. */
  readonly measure?: (spent: (cost_ms: number) => void) => void;
}

/** `frame`: before each displayed frame that the budget allows, for what moves. `text`: ten times a second, as fast as anybody reads. */
export type PaintRate = "frame" | "text";
export type Paint = (now_ms: number) => void;

/**
 * The one animation-frame loop of the page. Painters of a rate run together, so layout happens once; frames in which
 * nothing new arrived paint nothing but the tenth-of-a-second texts, which also find what has become stale. Where
 * frames are dear, instruments move in every second or third one.
 */
export class Pump {
  readonly #frames: FrameSource;
  readonly #revision: () => number;
  readonly #onFailure: (error: unknown) => void;
  /** Painters that threw and were reported. */
  readonly #reported = new WeakSet<Paint>();
  readonly #painters: Readonly<Record<PaintRate, Set<Paint>>> = { frame: new Set(), text: new Set() };
  #handle: number | null = null;
  readonly #budget = new RedrawBudget();
  #painted = -1;
  #frame_ms = Number.NEGATIVE_INFINITY;
  readonly #texts = new Pace(NUMBER_PERIOD_MS);
  #now_ms: number;

  /**
   * `revision` tells whether there is anything new: it differs from the last call's when there is. `onFailure` hears
   * once of each painter that throws.
   */
  constructor(
    frames: FrameSource,
    revision: () => number,
    now_ms: number,
    onFailure: (error: unknown) => void,
  ) {
    this.#frames = frames;
    this.#revision = revision;
    this.#now_ms = now_ms;
    this.#onFailure = onFailure;
  }

  /** Time of the newest text round: all that is decided by time in React agrees on it. */
  get now_ms(): number {
    return this.#now_ms;
  }

  /** Paint at this rate, first with the next frame, until the returned function is called. */
  add(rate: PaintRate, paint: Paint): () => void {
    const painters = this.#painters[rate];
    painters.add(paint);
    this.#painted = -1;
    this.#texts.reset();
    this.#handle ??= this.#frames.request(this.#frame);
    return () => {
      painters.delete(paint);
      if (this.#painters.frame.size === 0 && this.#painters.text.size === 0 && this.#handle !== null) {
        this.#frames.cancel(this.#handle);
        this.#handle = null;
      }
    };
  }

  /** As React wants a subscription: called with each round of texts. */
  readonly onTick = (changed: () => void): (() => void) => this.add("text", () => changed());

  readonly #frame = (now_ms: number): void => {
    this.#handle = this.#frames.request(this.#frame);
    const textIsDue = this.#texts.due(now_ms);
    const revision = this.#revision();
    const frameIsDue = now_ms - this.#frame_ms >= this.#budget.period_ms;
    if (textIsDue || (frameIsDue && revision !== this.#painted)) {
      this.#frames.measure?.((cost_ms) => this.#budget.observe(cost_ms));
      this.#painted = revision;
      this.#frame_ms = now_ms;
      this.#run("frame", now_ms);
    }
    if (textIsDue) {
      this.#now_ms = now_ms;
      this.#run("text", now_ms);
    }
  };

  /**
   * A painter that throws must not hold up the others: their ages would freeze and old values look live. It is called
   * again in each round, because it may fail at one value and not at the next, and left out it would show an old one.
   */
  #run(rate: PaintRate, now_ms: number): void {
    for (const paint of this.#painters[rate]) {
      try {
        paint(now_ms);
      } catch (error) {
        if (!this.#reported.has(paint)) {
          this.#reported.add(paint);
          this.#onFailure(error);
        }
      }
    }
  }
}
