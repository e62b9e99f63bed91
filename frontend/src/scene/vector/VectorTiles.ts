import { isDrawnLayer } from "./drawVector";
import { decodeVectorTile, type VectorLayer } from "./vectorTile";

/** Twice the usual side: names and thin roads stay sharp. */
export const VECTOR_PX = 512;
const MOST_KEPT = 24;
const MOST_BYTES = 8_000_000;

/** Read tiles, the last ones kept: many parts of one are drawn when the map is nearer than its source's finest level. */
export class VectorTiles {
  readonly #fetch: (address: string) => Promise<Response>;
  readonly #kept = new Map<string, Promise<readonly VectorLayer[] | null>>();

  constructor(ask: (address: string) => Promise<Response>) {
    this.#fetch = ask;
  }

  /** Null: there is none. Rejects if it cannot be read. */
  at(address: string): Promise<readonly VectorLayer[] | null> {
    const known = this.#kept.get(address);
    if (known !== undefined) {
      return known;
    }
    const asked = this.#read(address).catch((error: unknown) => {
      this.#kept.delete(address);
      throw error;
    });
    this.#kept.set(address, asked);
    const [oldest] = this.#kept.keys();
    if (this.#kept.size > MOST_KEPT && oldest !== undefined) {
      this.#kept.delete(oldest);
    }
    return asked;
  }

  async #read(address: string): Promise<readonly VectorLayer[] | null> {
    const answer = await this.#fetch(address);
    if (answer.status !== 200) {
      if (answer.status === 204 || answer.status === 404) return null;
      throw new Error(`${address}: ${answer.status}`);
    }
    const bytes = new Uint8Array(await answer.arrayBuffer());
    if (bytes.length > MOST_BYTES) {
      throw new Error(`${address}: ${bytes.length} bytes`);
    }
    return decodeVectorTile(bytes, isDrawnLayer);
  }
}

/** Which tile of the source shows a tile of the map, and what part of it. */
export function sourceOf(
  url: string,
  maximum_zoom: number,
  zoom: number,
  x: number,
  y: number,
): { readonly url: string; readonly part: { left: number; top: number; share: number } } {
  const above = Math.max(0, zoom - maximum_zoom);
  const share = 1 / 2 ** above;
  const [column, row] = [Math.floor(x * share), Math.floor(y * share)];
  return {
    url: url
      .replace("{z}", `${zoom - above}`)
      .replace("{x}", `${column}`)
      .replace("{y}", `${row}`),
    part: { left: x * share - column, top: y * share - row, share },
  };
}
