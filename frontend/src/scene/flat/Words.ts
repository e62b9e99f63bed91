import { EDGE } from "../colours";
import type { ScreenPoint } from "./projection";

/** Of the page's own size, which grows with the screen. */
const FONT = '600 0.85em "Inter Variable", system-ui, sans-serif';
const EDGE_PX = 3;
/** Of the letters' height, what they reach under the line on which they stand. */
const UNDER = 0.25;

interface Box {
  readonly left: number;
  readonly right: number;
  readonly top: number;
  readonly bottom: number;
}

/** The words of one picture: each beside its place, where no others stand. */
export class Words {
  readonly #context: CanvasRenderingContext2D;
  readonly #taken: Box[] = [];

  constructor(context: CanvasRenderingContext2D) {
    this.#context = context;
  }

  /** `away_px`: so far from the place. Where there is no room on any side they stand over others, at the first. */
  write(text: string, place: ScreenPoint, away_px: number, colour: string): void {
    const context = this.#context;
    context.font = FONT;
    const { width, fontBoundingBoxAscent: height } = context.measureText(text);
    const sides = sidesOf(place, away_px, width, height);
    const box = sides.find((side) => !this.#taken.some((taken) => isOver(side, taken))) ?? sides[0];
    this.#taken.push(box);
    context.lineJoin = "round";
    context.strokeStyle = EDGE;
    context.lineWidth = EDGE_PX;
    context.strokeText(text, box.left, box.bottom - UNDER * height);
    context.fillStyle = colour;
    context.fillText(text, box.left, box.bottom - UNDER * height);
  }
}

/** Right above, right below, left above, left below; then straight above and below. */
function sidesOf({ x, y }: ScreenPoint, away_px: number, width: number, height: number) {
  const tall = (1 + UNDER) * height;
  const at = (left: number, top: number): Box => ({ left, right: left + width, top, bottom: top + tall });
  const [above, below] = [y - tall - away_px / 2, y + away_px / 2];
  const [right, left, middle] = [x + away_px, x - away_px - width, x - width / 2];
  return [
    at(right, above),
    at(right, below),
    at(left, above),
    at(left, below),
    at(middle, above - away_px),
    at(middle, below + away_px),
  ] as const;
}

function isOver(one: Box, other: Box): boolean {
  return one.left < other.right && other.left < one.right && one.top < other.bottom && other.top < one.bottom;
}
