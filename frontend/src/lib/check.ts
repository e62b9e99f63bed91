/**
 * Checks of data from outside, composed of small ones. Each is a type guard. Unknown properties are allowed, so that
 * an older page works with a newer gateway.
 */
export type Check<T> = (value: unknown) => value is T;
export type Checked<C> = C extends Check<infer T> ? T : never;

export function isText(value: unknown): value is string {
  return typeof value === "string";
}

export function isFlag(value: unknown): value is boolean {
  return typeof value === "boolean";
}

/** A finite number: JSON has no others, but a forged message can hold 1e999. */
export function isNumber(value: unknown): value is number {
  return typeof value === "number" && Number.isFinite(value);
}

export function isObject(value: unknown): value is Readonly<Record<string, unknown>> {
  return typeof value === "object" && value !== null && !Array.isArray(value);
}

export function nullable<T>(check: Check<T>): Check<T | null> {
  return (value): value is T | null => value === null || check(value);
}

/** May be missing, for an older gateway does not send it. */
export function optional<T>(check: Check<T>): Check<T | undefined> {
  return (value): value is T | undefined => value === undefined || check(value);
}

export function oneOf<const T extends string>(...words: readonly T[]): Check<T> {
  const known: ReadonlySet<unknown> = new Set(words);
  return (value): value is T => known.has(value);
}

export function list<T>(check: Check<T>): Check<readonly T[]> {
  return (value): value is readonly T[] => Array.isArray(value) && value.every((entry) => check(entry));
}

export function dictionary<T>(check: Check<T>): Check<Readonly<Record<string, T>>> {
  return (value): value is Readonly<Record<string, T>> =>
    isObject(value) && Object.values(value).every((entry) => check(entry));
}

type Shape = Readonly<Record<string, Check<unknown>>>;

export function shape<S extends Shape>(fields: S): Check<{ readonly [K in keyof S]: Checked<S[K]> }> {
  const entries = Object.entries(fields);
  return (value): value is { readonly [K in keyof S]: Checked<S[K]> } =>
    isObject(value) && entries.every(([name, check]) => check(value[name]));
}
