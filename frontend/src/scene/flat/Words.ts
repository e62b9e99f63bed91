import type { LabelBox } from "../../lib/labels";
import type { LabelSheet, ShownText } from "../labels/LabelSheet";
import { FLIGHT_RANK } from "../lettering";
import type { ScreenPoint } from "./projection";

const FONT = '600 14px "Inter Variable", system-ui, sans-serif';

/** The texts of one picture, gathered while it is drawn, and painted last: no two lie over each other. */
export class Words {
  readonly #texts: ShownText[] = [];
  readonly #counts = new Map<string, number>();

  /** A text of the flight, `away_px` from its place. `more`: of two in one place the higher is nearer to it. */
  write(text: string, place: ScreenPoint, away_px: number, colour: string, more = 0): void {
    const name = `${colour}|${text}`;
    const count = (this.#counts.get(name) ?? 0) + 1;
    this.#counts.set(name, count);
    this.#texts.push({
      key: `${name}|${count}`,
      text,
      font: FONT,
      colour,
      rank: FLIGHT_RANK + more,
      at: place,
      away_px,
      isSought: true,
    });
  }

  add(text: ShownText): void {
    this.#texts.push(text);
  }

  paint(
    context: CanvasRenderingContext2D,
    sheet: LabelSheet,
    width_px: number,
    height_px: number,
    ratio: number,
    covered: readonly LabelBox[] = [],
  ): void {
    sheet.arrange(this.#texts, width_px, height_px, ratio, covered);
    sheet.paint(context);
  }
}
