import { angleBetween_deg, between, type Quaternion } from "./attitude";

/** The age of the attitude that the ghost shows. */
export const GHOST_MS = 1000;

/** Smaller movements are ignored: under a pixel at the wing tip of a large picture. */
const STILL_DEG = 0.02;
/** Limits of the time in which a sample is reached, which is else the usual time between two samples. */
const SHORTEST_MS = 15;
const LONGEST_MS = 250;
/** After such a gap there is no interpolation: the next sample is shown at once. */
const LAPSE_MS = 500;
const WEIGHT = 0.2;

interface Moment {
  readonly at_ms: number;
  readonly turn: Quaternion;
}

/**
 * Interpolates the attitude between samples, and knows that of a second ago. Each sample is reached when the next one
 * is expected: smooth at any rate, and behind by one period.
 */
export class AttitudeMotion {
  #from: Quaternion | null = null;
  #to: Quaternion | null = null;
  #start_ms = 0;
  #period_ms = LONGEST_MS / 2;
  #past: Moment[] = [];

  /** Add a sample received now. */
  push(turn: Quaternion, now_ms: number): void {
    const since_ms = now_ms - this.#start_ms;
    if (this.#to === null || since_ms > LAPSE_MS) {
      this.#past = [];
      this.#from = turn;
    } else {
      this.#period_ms += WEIGHT * (since_ms - this.#period_ms);
      this.#from = this.shown(now_ms);
    }
    this.#to = turn;
    this.#start_ms = now_ms;
    this.#past.push({ at_ms: now_ms, turn });
    const oldest = this.#past.findLastIndex(({ at_ms }) => at_ms <= now_ms - GHOST_MS);
    if (oldest > 0) {
      this.#past.splice(0, oldest);
    }
  }

  /** Another source: do not interpolate between its samples and the old ones. */
  clear(): void {
    this.#from = this.#to = null;
    this.#past = [];
  }

  shown(now_ms: number): Quaternion | null {
    if (this.#from === null || this.#to === null) {
      return null;
    }
    const way_ms = Math.max(SHORTEST_MS, Math.min(LONGEST_MS, this.#period_ms));
    const share = Math.max(0, Math.min(1, (now_ms - this.#start_ms) / way_ms));
    return between(this.#from, this.#to, share);
  }

  /** The attitude of a second ago; null if there was none. */
  ghost(now_ms: number): Quaternion | null {
    const then_ms = now_ms - GHOST_MS;
    const after = this.#past.findIndex(({ at_ms }) => at_ms > then_ms);
    const before = this.#past[after < 0 ? this.#past.length - 1 : after - 1];
    const next = this.#past[after];
    if (before === undefined) {
      return null;
    }
    return next === undefined
      ? before.turn
      : between(before.turn, next.turn, (then_ms - before.at_ms) / (next.at_ms - before.at_ms));
  }

  /** Whether the picture changes without another sample. */
  isMoving(now_ms: number, withGhost: boolean): boolean {
    const { shown, to } = { shown: this.shown(now_ms), to: this.#to };
    if (shown === null || to === null) {
      return false;
    }
    if (angleBetween_deg(shown, to) > STILL_DEG) {
      return true;
    }
    const ghost = this.ghost(now_ms);
    const isNew = ghost === null && this.#past.length > 0;
    return withGhost && (isNew || (ghost !== null && angleBetween_deg(ghost, to) > STILL_DEG));
  }
}
