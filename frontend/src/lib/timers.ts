/** Time and timers, from the browser or from a test. */
export interface Timers {
  readonly now_ms: () => number;
  readonly after: (delay_ms: number, run: () => void) => () => void;
}
