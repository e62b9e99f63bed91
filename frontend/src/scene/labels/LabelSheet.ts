import { type LabelBox, type PlacedLabel, placeLabels, type Spot, type WantedLabel } from "../../lib/labels";
import { EDGE } from "../colours";
import { drawMark, type Mark } from "./marks";
import { TextSprites } from "./TextSprites";

/** A text beside a place of the picture. */
export interface ShownText {
  /** The same from picture to picture. */
  readonly key: string;
  readonly text: string;
  /** CSS font; its size is in pixels. */
  readonly font: string;
  readonly colour: string;
  readonly rank: number;
  readonly at: Spot;
  readonly away_px: number;
  /** Must be read: it looks for room farther away, and a line leads to its place. */
  readonly isSought: boolean;
  /** Drawn at the place together with the text. */
  readonly mark?: Mark;
}

/** A text farther from its place than this, beyond its usual distance, has a line to it. */
const LEADER_PX = 14;
/** Half of what a mark of the flight takes. */
const MARK_PX = 5;
/** Places this far outside of the picture may still reach into it. */
const MARGIN_PX = 120;

/** The texts of one map, picture after picture: no two lie over each other, and none jumps without need. */
export class LabelSheet {
  readonly #sprites: Pick<TextSprites, "sizeOf" | "draw">;
  #placed: ReadonlyMap<string, PlacedLabel> = new Map();
  #shown: readonly ShownText[] = [];

  constructor(sprites: Pick<TextSprites, "sizeOf" | "draw"> = new TextSprites()) {
    this.#sprites = sprites;
  }

  /** Choose and place the texts of the next picture, of this size in CSS pixels; none lies in the boxes that are `covered`. */
  arrange(
    texts: readonly ShownText[],
    width_px: number,
    height_px: number,
    ratio: number,
    covered: readonly LabelBox[] = [],
  ): void {
    const near = texts.filter(
      ({ at }) =>
        at.x > -MARGIN_PX && at.y > -MARGIN_PX && at.x < width_px + MARGIN_PX && at.y < height_px + MARGIN_PX,
    );
    const wanted = near.map((text): WantedLabel => ({ ...text, ...this.#sprites.sizeOf(text, ratio) }));
    // No name lies over an aircraft or a waypoint.
    const marks = near.filter(({ isSought }) => isSought).map(({ at }) => markBox(at));
    const taken = [...marks, ...covered];
    this.#placed = placeLabels(wanted, this.#placed, taken, {
      left: 0,
      top: 0,
      right: width_px,
      bottom: height_px,
    });
    // What matters most is drawn last.
    this.#shown = near.filter(({ key }) => this.#placed.has(key)).sort((one, other) => one.rank - other.rank);
  }

  /** Where each text of the picture stands. */
  get placed(): ReadonlyMap<string, PlacedLabel> {
    return this.#placed;
  }

  /** The shown text or mark under a spot, within so many pixels; null: none. */
  find({ x, y }: Spot, reach_px: number): string | null {
    const found = this.#shown.findLast(({ key, at, mark }) => {
      const box = this.#placed.get(key)?.box;
      const isInText =
        box !== undefined && x >= box.left && x <= box.right && y >= box.top && y <= box.bottom;
      return isInText || (mark !== undefined && Math.hypot(at.x - x, at.y - y) <= reach_px);
    });
    return found?.key ?? null;
  }

  /** Paint what was arranged; the context draws in CSS pixels. */
  paint(context: CanvasRenderingContext2D): void {
    for (const { key, at, colour, away_px, isSought } of this.#shown) {
      const placed = this.#placed.get(key);
      if (isSought && placed !== undefined) {
        drawLeader(context, at, placed, away_px, colour);
      }
    }
    for (const text of this.#shown) {
      const placed = this.#placed.get(text.key);
      if (text.mark !== undefined) {
        drawMark(context, text.mark, text.at, text.colour);
      }
      if (placed !== undefined) {
        this.#sprites.draw(context, text, placed.box);
      }
    }
  }
}

function markBox({ x, y }: Spot): LabelBox {
  return { left: x - MARK_PX, right: x + MARK_PX, top: y - MARK_PX, bottom: y + MARK_PX };
}

function drawLeader(
  context: CanvasRenderingContext2D,
  at: Spot,
  { box }: PlacedLabel,
  away_px: number,
  colour: string,
): void {
  const x = Math.max(box.left, Math.min(box.right, at.x));
  const y = Math.max(box.top, Math.min(box.bottom, at.y));
  if (Math.hypot(x - at.x, y - at.y) < away_px + LEADER_PX) {
    return;
  }
  context.beginPath();
  context.moveTo(at.x, at.y);
  context.lineTo(x, y);
  context.strokeStyle = EDGE;
  context.lineWidth = 3;
  context.stroke();
  context.strokeStyle = colour;
  context.lineWidth = 1;
  context.stroke();
}
