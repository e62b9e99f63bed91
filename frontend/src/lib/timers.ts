/** Time and timers, from the browser or from a test. */
export interface Timers {
  readonly now_ms: () => number;
  readonly after: (delay_ms: number, run: () => void) => () => void;
  /** Hears what a repeated turn throws; by default the browser's console does. */
  readonly report?: (error: unknown) => void;
}

/** The browser's own, also that of a worker. */
export const BROWSER_TIMERS: Timers = {
  now_ms: () => performance.now(),
  after: (delay_ms, run) => {
    const handle = setTimeout(run, delay_ms);
    return () => clearTimeout(handle);
  },
};
