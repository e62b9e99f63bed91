/** Where animation frames come from: the browser's, or a test's. */
export interface AnimationFrames {
  readonly request: (callback: (now_ms: number) => void) => number;
  readonly cancel: (handle: number) => void;
  /** Called inside an animation frame: tells once what the page has spent on it, in milliseconds. */
  readonly measure?: (spent: (cost_ms: number) => void) => void;
}
