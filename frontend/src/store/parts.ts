/** Name of a private part of the page: only code that can import the name can read the part. */
export interface PartName<T> {
  readonly name: string;
  /** Carries the part's type; never set. */
  readonly part?: T;
}

export function partName<T>(name: string): PartName<T> {
  return { name };
}

/** The features' parts, by name. */
export class Parts {
  readonly #parts = new Map<PartName<unknown>, unknown>();

  with<T>(name: PartName<T>, part: T): this {
    this.#parts.set(name, part);
    return this;
  }

  /** A copy in which some parts can be replaced. */
  but(): Parts {
    const copy = new Parts();
    for (const [name, part] of this.#parts) {
      copy.#parts.set(name, part);
    }
    return copy;
  }

  get<T>(name: PartName<T>): T {
    if (!this.#parts.has(name)) {
      throw new Error(`the page was put together without its ${name.name}`);
    }
    return this.#parts.get(name) as T;
  }
}
