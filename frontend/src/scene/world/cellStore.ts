import { type Cell, type CellPlace, decodeCell, type WorldLevel } from "./cell";
import type { Box } from "./geometry";
import { cellsOf } from "./tiling";

const FOLDER = "/map/world";
/** Cells kept in memory, the ones used last. */
const MOST_CELLS = 80;

/** Which cells have a file, by level. */
type Index = Readonly<
  Record<`${WorldLevel}`, { readonly size_deg: number; readonly cells: readonly string[] }>
>;

interface KnownLevel {
  readonly size_deg: number;
  readonly cells: ReadonlySet<string>;
}

/** The map's cells: asked for once, kept, and forgotten in the order in which they were last used. */
export class CellStore {
  readonly #fetch: (address: string) => Promise<Response>;
  readonly #cells = new Map<string, Promise<Cell>>();
  #levels: Promise<readonly KnownLevel[]> | null = null;

  constructor(ask: (address: string) => Promise<Response>) {
    this.#fetch = ask;
  }

  /** All cells of a level that a box touches; where nothing is known there is none. */
  async within(level: WorldLevel, box: Box): Promise<Cell[]> {
    const known = (await this.#known())[level];
    if (known === undefined) {
      return [];
    }
    const places = cellsOf(level, known.size_deg, box).filter(({ column, row }) =>
      known.cells.has(`${column}-${row}`),
    );
    return await Promise.all(places.map((place) => this.#cell(place)));
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
      cells: new Set(index[level].cells),
    }));
  }

  #cell(place: CellPlace): Promise<Cell> {
    const key = `${place.level}/${place.column}-${place.row}`;
    const known = this.#cells.get(key);
    this.#cells.delete(key);
    const cell =
      known ??
      this.#readCell(`${FOLDER}/${key}.bin`, place).catch((error: unknown) => {
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

  async #readCell(address: string, place: CellPlace): Promise<Cell> {
    const { body } = await this.#ask(address);
    if (body === null) {
      throw new Error(`${address} is empty`);
    }
    const whole = new Response(body.pipeThrough(new DecompressionStream("gzip")));
    return decodeCell(new Uint8Array(await whole.arrayBuffer()), place);
  }

  async #ask(address: string): Promise<Response> {
    const answer = await this.#fetch(address);
    if (!answer.ok) {
      throw new Error(`${address}: ${answer.status}`);
    }
    return answer;
  }
}
