/**
 * Calls listeners one after the other. One that throws keeps neither the others from their turn nor itself from the next
 * one, for it may fail at one value and not at the next. It is reported once.
 */
export class GuardedCalls {
  readonly #report: (error: unknown) => void;
  readonly #reported = new WeakSet<object>();

  constructor(report: (error: unknown) => void) {
    this.#report = report;
  }

  each<T extends object>(listeners: Iterable<T>, call: (listener: T) => void): void {
    for (const listener of listeners) {
      try {
        call(listener);
      } catch (error) {
        if (!this.#reported.has(listener)) {
          this.#reported.add(listener);
          this.#report(error);
        }
      }
    }
  }
}
