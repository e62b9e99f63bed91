import type { LabelBox } from "../../lib/labels";
import { EDGE } from "../colours";

/** What a text's picture depends on. */
interface TextLook {
  readonly text: string;
  readonly font: string;
  readonly colour: string;
}

interface Sprite {
  readonly canvas: HTMLCanvasElement;
  readonly width: number;
  readonly height: number;
  readonly ratio: number;
}

const OUTLINE_PX = 3;
const MOST = 700;

/** Texts with a dark outline, painted once: stroking letters takes longer than all else of a picture of names. */
export class TextSprites {
  /** In the order of last use. */
  readonly #sprites = new Map<string, Sprite>();
  #ratio = 1;

  /** Width and height in CSS pixels, outline included; `ratio`: device pixels of one. */
  sizeOf(text: TextLook, ratio: number): { readonly width: number; readonly height: number } {
    this.#ratio = ratio;
    return this.#sprite(text);
  }

  draw(context: CanvasRenderingContext2D, text: TextLook, { left, top }: LabelBox): void {
    const { canvas, width, height } = this.#sprite(text);
    // On whole pixels, or the letters blur.
    const x = Math.round(left * this.#ratio) / this.#ratio;
    const y = Math.round(top * this.#ratio) / this.#ratio;
    context.drawImage(canvas, x, y, width, height);
  }

  #sprite(text: TextLook): Sprite {
    const key = `${text.font}|${text.colour}|${text.text}`;
    const known = this.#sprites.get(key);
    if (known !== undefined) {
      this.#sprites.delete(key);
    }
    const sprite = known?.ratio === this.#ratio ? known : painted(text, this.#ratio);
    this.#sprites.set(key, sprite);
    for (const oldest of this.#sprites.keys()) {
      if (this.#sprites.size <= MOST) {
        break;
      }
      this.#sprites.delete(oldest);
    }
    return sprite;
  }
}

function painted({ text, font, colour }: TextLook, ratio: number): Sprite {
  const canvas = document.createElement("canvas");
  const context = canvas.getContext("2d");
  if (context === null) {
    return { canvas, width: 0, height: 0, ratio };
  }
  context.font = font;
  const {
    width: letters,
    fontBoundingBoxAscent: up,
    fontBoundingBoxDescent: down,
  } = context.measureText(text);
  canvas.width = Math.max(1, Math.ceil((letters + 2 * OUTLINE_PX) * ratio));
  canvas.height = Math.max(1, Math.ceil((up + down + 2) * ratio));
  context.scale(ratio, ratio);
  context.font = font;
  context.lineJoin = "round";
  context.lineWidth = OUTLINE_PX;
  context.strokeStyle = EDGE;
  context.strokeText(text, OUTLINE_PX, up + 1);
  context.fillStyle = colour;
  context.fillText(text, OUTLINE_PX, up + 1);
  return { canvas, width: canvas.width / ratio, height: canvas.height / ratio, ratio };
}
