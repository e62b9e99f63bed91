/**
 * Checks of data from outside, composed of small ones. Each is a type guard. Unknown properties are allowed, so that
 * an older page works with a newer gateway. The functions that make checks are marked as free of side effects: the
 * build leaves out every check that nothing uses.
 */
export interface Check<T> {
  (value: unknown): value is T;
  /** The result of `faultIn`; missing if a check has no parts. */
  readonly fault?: (value: unknown) => string | null;
}
export type Checked<C> = C extends Check<infer T> ? T : never;

/** Path of the first part that does not fit: `.board.state`, `.layers[3].id`, empty for the value itself; else null. */
export function faultIn(check: Check<unknown>, value: unknown): string | null {
  if (check.fault !== undefined) {
    return check.fault(value);
  }
  return check(value) ? null : "";
}

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

/* @__NO_SIDE_EFFECTS__ */
function checkBy<T>(fault: (value: unknown) => string | null): Check<T> {
  return Object.assign((value: unknown): value is T => fault(value) === null, { fault });
}

/* @__NO_SIDE_EFFECTS__ */
export function nullable<T>(check: Check<T>): Check<T | null> {
  return checkBy((value) => (value === null ? null : faultIn(check, value)));
}

/** May be missing, for an older gateway does not send it. */
/* @__NO_SIDE_EFFECTS__ */
export function optional<T>(check: Check<T>): Check<T | undefined> {
  return checkBy((value) => (value === undefined ? null : faultIn(check, value)));
}

/* @__NO_SIDE_EFFECTS__ */
export function oneOf<const T extends string>(...words: readonly T[]): Check<T> {
  const known: ReadonlySet<unknown> = new Set(words);
  return (value): value is T => known.has(value);
}

/* @__NO_SIDE_EFFECTS__ */
export function either<C extends readonly Check<unknown>[]>(...checks: C): Check<Checked<C[number]>> {
  return (value): value is Checked<C[number]> => checks.some((check) => check(value));
}

/* @__NO_SIDE_EFFECTS__ */
export function list<T>(check: Check<T>): Check<readonly T[]> {
  return checkBy((value) =>
    Array.isArray(value) ? firstFault(value.entries(), check, (index) => `[${index}]`) : "",
  );
}

/* @__NO_SIDE_EFFECTS__ */
export function dictionary<T>(check: Check<T>): Check<Readonly<Record<string, T>>> {
  return checkBy((value) =>
    isObject(value) ? firstFault(Object.entries(value), check, (key) => `.${key}`) : "",
  );
}

function firstFault<K>(
  entries: Iterable<readonly [K, unknown]>,
  check: Check<unknown>,
  step: (key: K) => string,
): string | null {
  for (const [key, entry] of entries) {
    const fault = faultIn(check, entry);
    if (fault !== null) {
      return step(key) + fault;
    }
  }
  return null;
}

type Fields = Readonly<Record<string, Check<unknown>>>;

/** A check of an object; `fields` are the checks of its properties, from which other shapes can be built. */
export type ShapeCheck<F extends Fields> = Check<{ readonly [K in keyof F]: Checked<F[K]> }> & {
  readonly fields: F;
};

/* @__NO_SIDE_EFFECTS__ */
export function shape<F extends Fields>(fields: F): ShapeCheck<F> {
  const entries = Object.entries(fields);
  const check = checkBy<{ readonly [K in keyof F]: Checked<F[K]> }>((value) => {
    if (!isObject(value)) {
      return "";
    }
    for (const [name, field] of entries) {
      const fault = faultIn(field, value[name]);
      if (fault !== null) {
        return `.${name}${fault}`;
      }
    }
    return null;
  });
  return Object.assign(check, { fields });
}
