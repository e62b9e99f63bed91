import { GuardedCalls } from "../lib/guardedCalls";
import { NUMBER_PERIOD_MS, Pace } from "../lib/pace";
import type { AnimationFrames } from "../lib/timers";
import { RedrawBudget } from "./paintBudget";

/** `movement`: in each animation frame that the budget allows. `text`: ten times a second, as fast as anybody reads. */
export type PaintRate = "movement" | "text";
export type Paint = (now_ms: number) => void;

/**
 * The one animation-frame loop of the page. Painters of a rate run together, so layout happens once; animation frames
 * in which nothing new arrived paint nothing but the tenth-of-a-second texts, which also find what has become stale.
 * Where they are dear, instruments move in every second or third one.
 */
export class Pump {
  readonly #animationFrames: AnimationFrames;
  readonly #revision: () => number;
  readonly #calls: GuardedCalls;
  readonly #painters: Readonly<Record<PaintRate, Set<Paint>>> = { movement: new Set(), text: new Set() };
  #handle: number | null = null;
  readonly #budget = new RedrawBudget();
  #painted = -1;
  #moved_ms = Number.NEGATIVE_INFINITY;
  readonly #texts = new Pace(NUMBER_PERIOD_MS);
  #now_ms: number;

  /**
   * `revision` tells whether there is anything new: it differs from the last call's when there is. `onFailure` hears
   * once of each painter that throws.
   */
  constructor(
    animationFrames: AnimationFrames,
    revision: () => number,
    now_ms: number,
    onFailure: (error: unknown) => void,
  ) {
    this.#animationFrames = animationFrames;
    this.#revision = revision;
    this.#now_ms = now_ms;
    this.#calls = new GuardedCalls(onFailure);
  }

  /** Time of the newest text round: all that is decided by time in React agrees on it. */
  get now_ms(): number {
    return this.#now_ms;
  }

  /** Paint at this rate, first with the next animation frame, until the returned function is called. */
  add(rate: PaintRate, paint: Paint): () => void {
    const painters = this.#painters[rate];
    painters.add(paint);
    this.#painted = -1;
    this.#texts.reset();
    this.#handle ??= this.#animationFrames.request(this.#animate);
    return () => {
      painters.delete(paint);
      if (this.#painters.movement.size === 0 && this.#painters.text.size === 0 && this.#handle !== null) {
        this.#animationFrames.cancel(this.#handle);
        this.#handle = null;
      }
    };
  }

  /** Another moment is shown: texts too are painted with the next animation frame, whatever their pace. */
  hurry(): void {
    Pace.hurry();
    this.#moved_ms = Number.NEGATIVE_INFINITY;
  }

  /** As React wants a subscription: called with each round of texts. */
  readonly onTick = (changed: () => void): (() => void) => this.add("text", () => changed());

  readonly #animate = (now_ms: number): void => {
    this.#handle = this.#animationFrames.request(this.#animate);
    const textIsDue = this.#texts.due(now_ms);
    const revision = this.#revision();
    const movementIsDue = now_ms - this.#moved_ms >= this.#budget.period_ms;
    if (textIsDue || (movementIsDue && revision !== this.#painted)) {
      this.#animationFrames.measure?.((cost_ms) => this.#budget.observe(cost_ms));
      this.#painted = revision;
      this.#moved_ms = now_ms;
      this.#run("movement", now_ms);
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
    this.#calls.each(this.#painters[rate], (paint) => paint(now_ms));
  }
}
