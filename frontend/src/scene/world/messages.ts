import type { Position } from "../../lib/geodesy";
import type { Light } from "../look";
import type { TilePart, VectorName } from "../vector/drawVector";
import type { NamedThing, NamedZone, NearAirfield } from "./things";
import type { TilePlace } from "./tiling";

/** What the page asks the map's worker. */
export type WorldQuestion =
  | {
      readonly kind: "tile";
      readonly tile: TilePlace;
      readonly light: Light;
      /** Of sea and land. */
      readonly opacity: number;
      /** Upside down, as the graphics take a bitmap. */
      readonly isFlipped: boolean;
    }
  | {
      readonly kind: "things";
      readonly centre: Position;
      readonly zones: readonly NamedZone[];
      /** From how far the middle is seen. */
      readonly sight_m: number;
      readonly most: number;
    }
  | {
      /** Roads, rivers and buildings: a tile of this address as it is seen at `zoom`. */
      readonly kind: "vector";
      readonly url: string;
      readonly part: TilePart;
      readonly zoom: number;
      readonly light: Light;
      readonly isFlipped: boolean;
    }
  | { readonly kind: "near"; readonly place: Position; readonly most: number }
  | { readonly kind: "airfield"; readonly place: Position; readonly code: string };

export interface DrawnVector {
  readonly picture: ImageBitmap;
  readonly names: readonly VectorName[];
}

export interface WorldAnswers {
  readonly tile: ImageBitmap;
  readonly vector: DrawnVector | null;
  readonly things: NamedThing[];
  readonly near: NearAirfield[];
  readonly airfield: NearAirfield[];
}

export type NumberedQuestion = WorldQuestion & { readonly number: number };
export type NumberedAnswer =
  | { readonly number: number; readonly answer: WorldAnswers[keyof WorldAnswers] }
  | { readonly number: number; readonly fault: string };
