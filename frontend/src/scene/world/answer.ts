import { distance_m, METRES_PER_DEGREE, type Position } from "../../lib/geodesy";
import { GROUND } from "../look";
import { drawVector, namesOf } from "../vector/drawVector";
import { VECTOR_PX, VectorTiles } from "../vector/VectorTiles";
import type { Cell } from "./cell";
import type { CellStore } from "./cellStore";
import { drawTile } from "./drawTile";
import type { Box } from "./geometry";
import type { DrawnVector, WorldAnswers, WorldQuestion } from "./messages";
import { highest, type NearAirfield, nearestOf, thingsIn } from "./things";
import { frameOf, levelFor, WORLD_TILE_PX } from "./tiling";

/** Airfields are looked for in squares of these sides, the larger when the smaller hold too few. */
const NEAR_DEG = [1, 4] as const;
/** An airfield of another source's code may be a little elsewhere. */
const SAME_M = 5000;

/** Answers one question about the map. */
export async function answerOf(
  store: CellStore,
  question: WorldQuestion,
): Promise<WorldAnswers[keyof WorldAnswers]> {
  switch (question.kind) {
    case "tile":
      return await tileOf(store, question);
    case "vector":
      return await vectorOf(question);
    case "things":
      return await thingsOf(store, question);
    case "near":
      return await nearOf(store, question.place, question.most);
    case "airfield": {
      const cells = await store.within(2, around(question.place, SAME_M));
      return cells
        .flatMap(({ airfields }) => airfields)
        .filter(({ code }) => code === question.code)
        .map((airfield) => ({ airfield, away_m: distance_m(question.place, airfield) }));
    }
  }
}

async function tileOf(store: CellStore, question: WorldQuestion & { kind: "tile" }): Promise<ImageBitmap> {
  const { tile, light, opacity, isFlipped } = question;
  const frame = frameOf(tile);
  const cells = await store.within(levelFor(frame.metresPerPixel), frame.box);
  const canvas = new OffscreenCanvas(WORLD_TILE_PX, WORLD_TILE_PX);
  const context = canvas.getContext("2d");
  if (context === null) {
    throw new Error("this browser draws no pictures beside the page");
  }
  drawTile(context, tile.projection, frame, cells, GROUND[light], opacity);
  if (!isFlipped) {
    return canvas.transferToImageBitmap();
  }
  return await createImageBitmap(canvas, { imageOrientation: "flipY" });
}

const tiles = new VectorTiles((address) => fetch(address));

/** Null: the pack has no tile there. */
async function vectorOf(question: WorldQuestion & { kind: "vector" }): Promise<DrawnVector | null> {
  const { url, part, zoom, light, isFlipped } = question;
  const layers = await tiles.at(url);
  if (layers === null) {
    return null;
  }
  const canvas = new OffscreenCanvas(VECTOR_PX, VECTOR_PX);
  const context = canvas.getContext("2d");
  if (context === null) {
    throw new Error("this browser draws no pictures beside the page");
  }
  drawVector(context as unknown as CanvasRenderingContext2D, layers, part, VECTOR_PX, zoom + 1, light);
  const picture = isFlipped
    ? await createImageBitmap(canvas, { imageOrientation: "flipY" })
    : canvas.transferToImageBitmap();
  return { picture, names: namesOf(layers, part) };
}

async function thingsOf(store: CellStore, question: WorldQuestion & { kind: "things" }) {
  const { centre, zones, sight_m, most } = question;
  const found = await Promise.all(
    zones.map(async (zone) => {
      const cells = await store.within(zone.level, around(centre, zone.to_m));
      return cells.flatMap((cell) => thingsIn(cell, zone, centre, sight_m));
    }),
  );
  return highest(found.flat(), most);
}

async function nearOf(store: CellStore, place: Position, most: number): Promise<NearAirfield[]> {
  let cells: readonly Cell[] = [];
  for (const reach_deg of NEAR_DEG) {
    const reach_m = reach_deg * METRES_PER_DEGREE;
    cells = await store.within(2, around(place, reach_m));
    const near = nearestOf(cells, place, most);
    if (near.length === most && near.every(({ away_m }) => away_m <= reach_m)) {
      return near;
    }
  }
  return nearestOf(cells, place, most);
}

/** A box of at least so many metres to all sides. */
function around({ longitude_deg, latitude_deg }: Position, reach_m: number): Box {
  const north = reach_m / METRES_PER_DEGREE;
  const east = north / Math.max(0.05, Math.cos((latitude_deg * Math.PI) / 180));
  return {
    west_deg: longitude_deg - east,
    east_deg: longitude_deg + east,
    south_deg: latitude_deg - north,
    north_deg: latitude_deg + north,
  };
}
