import { type Cell, type CellPlace, decodeCell, type WorldLevel } from "./cell";
import type { Box } from "./geometry";
import { cellsOf } from "./tiling";

const FOLDER = "/map/world";
/** Cells kept in memory, the ones used last. */
const MOST_CELLS = 80;

/** Where a cell lies in the file of all cells: first byte, and how many. */
type Stretch = readonly [from: number, bytes: number];

/** Which cells there are, by level. */
type Index = Readonly<
  Record<`${WorldLevel}`, { readonly size_deg: number; readonly cells: Readonly<Record<string, Stretch>> }>
>;

interface KnownLevel {
  readonly size_deg: number;
  readonly cells: ReadonlyMap<string, Stretch>;
}

/** Asks for a file, or for a part of it. */
export type Ask = (address: string, headers?: Readonly<Record<string, string>>) => Promise<Response>;

/** The map's cells: asked for once, kept, and forgotten in the order in which they were last used. */
export class CellStore {
  readonly #fetch: Ask;
  readonly #cells = new Map<string, Promise<Cell>>();
  #levels: Promise<readonly KnownLevel[]> | null = null;

  constructor(ask: Ask) {
    this.#fetch = ask;
  }

  /** All cells of a level that a box touches; where nothing is known there is none. */
  async within(level: WorldLevel, box: Box): Promise<Cell[]> {
    const known = (await this.#known())[level];
    if (known === undefined) {
      return [];
    }
    return await Promise.all(
      cellsOf(level, known.size_deg, box).flatMap((place) => {
        const stretch = known.cells.get(`${place.column}-${place.row}`);
        return stretch === undefined ? [] : [this.#cell(place, stretch)];
      }),
    );
  }

  #known(): Promise<readonly KnownLevel[]> {
    this.#levels ??= this.#readIndex().catch((error: unknown) => {
      // Asked for again with the next question: the gateway may have been away.
      this.#levels = null;
      throw error;
    });
    return this.#levels;
  }

  async #readIndex(): Promise<readonly KnownLevel[]> {
    const index = (await (await this.#ask(`${FOLDER}/index.json`)).json()) as Index;
    return ([0, 1, 2] as const).map((level) => ({
      size_deg: index[level].size_deg,
      cells: new Map(Object.entries(index[level].cells)),
    }));
  }

  #cell(place: CellPlace, stretch: Stretch): Promise<Cell> {
    const key = `${place.level}/${place.column}-${place.row}`;
    const known = this.#cells.get(key);
    this.#cells.delete(key);
    const cell =
      known ??
      this.#readCell(place, stretch).catch((error: unknown) => {
        this.#cells.delete(key);
        throw error;
      });
    this.#cells.set(key, cell);
    for (const oldest of this.#cells.keys()) {
      if (this.#cells.size <= MOST_CELLS) {
        break;
      }
      this.#cells.delete(oldest);
    }
    return cell;
  }

  async #readCell(place: CellPlace, [from, bytes]: Stretch): Promise<Cell> {
    const answer = await this.#ask(`${FOLDER}/cells.bin`, { Range: `bytes=${from}-${from + bytes - 1}` });
    const told = await answer.blob();
    // A server that does not know parts sends the whole file.
    const packed = answer.status === 206 ? told : told.slice(from, from + bytes);
    const whole = new Response(packed.stream().pipeThrough(new DecompressionStream("gzip")));
    return decodeCell(new Uint8Array(await whole.arrayBuffer()), place);
  }

  async #ask(...what: Parameters<Ask>): Promise<Response> {
    const answer = await this.#fetch(...what);
    if (!answer.ok) {
      throw new Error(`${what[0]}: ${answer.status}`);
    }
    return answer;
  }
}
