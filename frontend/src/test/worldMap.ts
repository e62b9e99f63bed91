import { readFileSync } from "node:fs";
import { join } from "node:path";
import type { Ask } from "../scene/world/cellStore";

const PUBLIC = join(import.meta.dirname, "../../public");

type Levels = Readonly<
  Record<string, { readonly cells: Readonly<Record<string, readonly [from: number, bytes: number]>> }>
>;

const { sha256, ...levels } = JSON.parse(
  readFileSync(join(PUBLIC, "map/world/index.json"), "utf8"),
) as Levels & { readonly sha256: string };

export const WORLD_LEVELS: Levels = levels;
/** Of all cells, as the index says. */
export const WORLD_SHA256 = sha256;
/** All cells, one after the other. */
export const WORLD_CELLS = readFileSync(join(PUBLIC, "map/world/cells.bin"));

/** A cell of the map that ships, as it lies in the file of all cells. */
export function packedCell(level: number, cell: string): Buffer {
  const [from = 0, bytes = 0] = WORLD_LEVELS[level]?.cells[cell] ?? [];
  return WORLD_CELLS.subarray(from, from + bytes);
}

/** Answers as the gateway does with the files beside the page: whole, or the part that is asked for. */
export const askWorld: Ask = async (address, headers) => {
  const file = address === "/map/world/cells.bin" ? WORLD_CELLS : readFileSync(join(PUBLIC, address));
  const [, from, last] = /^bytes=(\d+)-(\d+)$/.exec(headers?.["Range"] ?? "") ?? [];
  return from === undefined
    ? new Response(file)
    : new Response(file.subarray(Number(from), Number(last) + 1), { status: 206 });
};
