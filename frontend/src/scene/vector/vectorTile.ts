/** Roads, rivers and buildings of one tile (MVT 2), as a stranger's server sent them: nothing in them is believed. */

/** Lines and rings in shares of the tile's side from its north-western corner. */
export interface VectorFeature {
  readonly kind: "point" | "line" | "area";
  readonly shapes: readonly (readonly number[])[];
  readonly tags: ReadonlyMap<string, string>;
}

export interface VectorLayer {
  readonly name: string;
  readonly features: readonly VectorFeature[];
}

/** More than any tile for a screen has; a tile that says more is drawn as far as that. */
const MOST_FEATURES = 60_000;
const MOST_POINTS = 600_000;
const MOST_LAYERS = 64;
const KINDS = ["point", "line", "area"] as const;

const MOVE = 1;
const LINE = 2;
const CLOSE = 7;

class Budget {
  features = MOST_FEATURES;
  points = MOST_POINTS;
}

/** The layers whose names are wanted. Throws on bytes that are no vector tile. */
export function decodeVectorTile(bytes: Uint8Array, isWanted: (layer: string) => boolean): VectorLayer[] {
  const budget = new Budget();
  const layers: VectorLayer[] = [];
  for (const { number, value } of fieldsOf(bytes)) {
    if (number === 3 && value instanceof Uint8Array && layers.length < MOST_LAYERS) {
      const layer = layerOf(value, isWanted, budget);
      if (layer !== null) {
        layers.push(layer);
      }
    }
  }
  return layers;
}

interface LayerParts {
  name: string;
  extent: number;
  readonly keys: string[];
  readonly said: string[];
  readonly features: Uint8Array[];
}

function layerOf(
  bytes: Uint8Array,
  isWanted: (layer: string) => boolean,
  budget: Budget,
): VectorLayer | null {
  const { name, extent, keys, said, features } = partsOf(bytes);
  if (!isWanted(name) || !(extent >= 1 && extent <= 65_536)) {
    return null;
  }
  const found: VectorFeature[] = [];
  for (const feature of features) {
    if (budget.features <= 0 || budget.points <= 0) break;
    budget.features -= 1;
    found.push(featureOf(feature, keys, said, extent, budget));
  }
  return { name, features: found };
}

function partsOf(bytes: Uint8Array): LayerParts {
  const parts: LayerParts = { name: "", extent: 4096, keys: [], said: [], features: [] };
  const take: Readonly<Record<number, (value: Uint8Array) => void>> = {
    1: (value) => {
      parts.name = textOf(value);
    },
    2: (value) => parts.features.push(value),
    3: (value) => parts.keys.push(textOf(value)),
    4: (value) => parts.said.push(saidOf(value)),
  };
  for (const { number, value } of fieldsOf(bytes)) {
    if (value instanceof Uint8Array) {
      take[number]?.(value);
    } else if (number === 5) {
      parts.extent = value;
    }
  }
  return parts;
}

function featureOf(
  bytes: Uint8Array,
  keys: readonly string[],
  said: readonly string[],
  extent: number,
  budget: Budget,
): VectorFeature {
  let tags: ReadonlyMap<string, string> = new Map();
  let kind: VectorFeature["kind"] = "point";
  let shapes: readonly (readonly number[])[] = [];
  for (const { number, value } of fieldsOf(bytes)) {
    if (typeof value === "number") {
      if (number === 3) kind = KINDS[value - 1] ?? "point";
    } else if (number === 2) {
      tags = tagsOf(value, keys, said);
    } else if (number === 4) {
      shapes = shapesOf(value, extent, budget);
    }
  }
  return { kind, shapes, tags };
}

function tagsOf(bytes: Uint8Array, keys: readonly string[], said: readonly string[]): Map<string, string> {
  const tags = new Map<string, string>();
  const numbers = new Reader(bytes);
  while (numbers.has) {
    const key = keys[numbers.varint()];
    const value = numbers.has ? said[numbers.varint()] : undefined;
    if (key !== undefined && value !== undefined) {
      tags.set(key, value);
    }
  }
  return tags;
}

/** Each command takes bytes of its own or is done once: what a few bytes claim is never what is made. */
function shapesOf(bytes: Uint8Array, extent: number, budget: Budget): number[][] {
  const reader = new Reader(bytes);
  const shapes: number[][] = [];
  const at = { x: 0, y: 0 };
  while (reader.has && budget.points > 0) {
    const command = reader.varint();
    const shape = shapes.at(-1) ?? [];
    switch (command % 8) {
      case CLOSE:
        // A ring is closed by its first point.
        shape.push(...shape.slice(0, 2));
        budget.points -= 1;
        break;
      case MOVE:
      case LINE:
        step(reader, command, at, extent, shapes, budget);
        break;
      default:
        throw new Error("not a vector tile");
    }
  }
  return shapes;
}

function step(
  reader: Reader,
  command: number,
  at: { x: number; y: number },
  extent: number,
  shapes: number[][],
  budget: Budget,
): void {
  for (let left = Math.floor(command / 8); left > 0 && reader.has && budget.points > 0; left -= 1) {
    at.x += reader.signed();
    at.y += reader.signed();
    if (command % 8 === MOVE) {
      shapes.push([]);
    }
    shapes.at(-1)?.push(at.x / extent, at.y / extent);
    budget.points -= 1;
  }
}

interface Field {
  readonly number: number;
  /** Bytes, or a number (0 for one of a fixed length). */
  readonly value: Uint8Array | number;
}

function* fieldsOf(bytes: Uint8Array): Generator<Field> {
  const reader = new Reader(bytes);
  while (reader.has) {
    const key = reader.varint();
    const kind = key & 7;
    if (kind === 0) yield { number: key >>> 3, value: reader.varint() };
    else if (kind === 2) yield { number: key >>> 3, value: reader.bytes(reader.varint()) };
    else if (kind === 1 || kind === 5) {
      reader.bytes(kind === 1 ? 8 : 4);
      yield { number: key >>> 3, value: 0 };
    } else throw new Error("not a vector tile");
  }
}

class Reader {
  readonly #bytes: Uint8Array;
  #at = 0;

  constructor(bytes: Uint8Array) {
    this.#bytes = bytes;
  }

  get has(): boolean {
    return this.#at < this.#bytes.length;
  }

  varint(): number {
    let value = 0;
    for (let shift = 0; shift < 70; shift += 7) {
      const byte = this.#bytes[this.#at];
      if (byte === undefined) break;
      this.#at += 1;
      value += (byte & 0x7f) * 2 ** shift;
      if (byte < 0x80) return value;
    }
    throw new Error("the vector tile is cut");
  }

  signed(): number {
    const value = this.varint();
    return value % 2 === 0 ? value / 2 : -(value + 1) / 2;
  }

  bytes(length: number): Uint8Array {
    const end = this.#at + length;
    if (end > this.#bytes.length) throw new Error("the vector tile is cut");
    const found = this.#bytes.subarray(this.#at, end);
    this.#at = end;
    return found;
  }
}

const decoder = new TextDecoder();
const MOST_TEXT = 200;

function textOf(bytes: Uint8Array): string {
  return decoder.decode(bytes.subarray(0, MOST_TEXT));
}

/** Texts as they are, whole numbers and flags as text; others do not matter to the drawing. */
function saidOf(bytes: Uint8Array): string {
  for (const { number, value } of fieldsOf(bytes)) {
    if (value instanceof Uint8Array) return number === 1 ? textOf(value) : "";
    return number === 6 ? String(value % 2 === 0 ? value / 2 : -(value + 1) / 2) : String(value);
  }
  return "";
}
