import type { AnimationFrames } from "../lib/timers";

/** Animation frames under the test's control. */
export class ManualAnimationFrames implements AnimationFrames {
  #pending = new Map<number, (now_ms: number) => void>();
  #next = 1;

  readonly request = (callback: (now_ms: number) => void): number => {
    const handle = this.#next++;
    this.#pending.set(handle, callback);
    return handle;
  };

  readonly cancel = (handle: number): void => {
    this.#pending.delete(handle);
  };

  get waiting(): number {
    return this.#pending.size;
  }

  /** Run one animation frame at this time. */
  show(now_ms: number): void {
    const callbacks = [...this.#pending.values()];
    this.#pending.clear();
    for (const callback of callbacks) {
      callback(now_ms);
    }
  }
}
