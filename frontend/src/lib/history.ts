/** Undo and redo of a value: every state is kept whole, which is cheap for values that are small and never changed in place. */
export interface History<T> {
  readonly past: readonly T[];
  readonly present: T;
  readonly future: readonly T[];
}

/** As far back as one goes; more would only cost memory. */
const DEPTH = 200;

export function begun<T>(present: T): History<T> {
  return { past: [], present, future: [] };
}

/** One edit on; what was undone before is given up. The same value again is no edit. */
export function edited<T>(history: History<T>, present: T): History<T> {
  return present === history.present
    ? history
    : { past: [...history.past, history.present].slice(-DEPTH), present, future: [] };
}

/** The newest edit taken further: no step of its own. For a key that is held down, which is one edit to its undo. */
export function amended<T>(history: History<T>, present: T): History<T> {
  return present === history.present ? history : { ...history, present, future: [] };
}

/** One edit back, or the same history where there is none. */
export function undone<T>(history: History<T>): History<T> {
  const before = history.past.at(-1);
  return before === undefined
    ? history
    : { past: history.past.slice(0, -1), present: before, future: [history.present, ...history.future] };
}

export function redone<T>(history: History<T>): History<T> {
  const [after, ...future] = history.future;
  return after === undefined ? history : { past: [...history.past, history.present], present: after, future };
}
