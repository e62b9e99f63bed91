/** Undo and redo of a value: every state is kept whole, which is cheap for small immutable values. */
export interface History<T> {
  readonly past: readonly T[];
  readonly present: T;
  readonly future: readonly T[];
}

/** Greatest number of undo steps, to bound memory. */
const DEPTH = 200;

export function begun<T>(present: T): History<T> {
  return { past: [], present, future: [] };
}

/** Add an edit and drop the redo steps. The same value again is no edit. */
export function edited<T>(history: History<T>, present: T): History<T> {
  return present === history.present
    ? history
    : { past: [...history.past, history.present].slice(-DEPTH), present, future: [] };
}

/** Extend the newest edit without a step of its own: the repeats of a held key are one edit. */
export function amended<T>(history: History<T>, present: T): History<T> {
  return present === history.present ? history : { ...history, present, future: [] };
}

/** Undo one edit; the same history if there is none. */
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
