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

/** Where animation frames come from: the browser's, or a test's. */
export interface AnimationFrames {
  readonly request: (callback: (now_ms: number) => void) => number;
  readonly cancel: (handle: number) => void;
  /** Called inside an animation frame: tells once what the page has spent on it, in milliseconds. */
  readonly measure?: (spent: (cost_ms: number) => void) => void;
}

/**
 * Reports a duration, since `start_ms` of `performance.now()`, to the browser's performance tools and to a bench.
 * Nothing is stored.
 */
export function tellTiming(name: string, start_ms: number): void {
  performance.measure(name, { start: start_ms });
  performance.clearMeasures(name);
}
