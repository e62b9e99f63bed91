import { EDGE } from "../colours";
import type { ScreenPoint } from "./projection";

const FONT = '600 12px "Inter Variable", system-ui, sans-serif';

export interface Pen {
  readonly colour: string;
  readonly width_px: number;
  readonly isDashed?: boolean;
}

/** A line with a dark edge, which is seen on any picture. */
export function drawLine(
  context: CanvasRenderingContext2D,
  points: readonly ScreenPoint[],
  { colour, width_px, isDashed = false }: Pen,
): void {
  context.lineJoin = "round";
  context.lineCap = "butt";
  context.setLineDash(isDashed ? [10, 6] : []);
  context.beginPath();
  for (const [index, { x, y }] of points.entries()) {
    if (index === 0) {
      context.moveTo(x, y);
    } else {
      context.lineTo(x, y);
    }
  }
  strokeTwice(context, colour, width_px);
  context.setLineDash([]);
}

export function drawDot(
  context: CanvasRenderingContext2D,
  { x, y }: ScreenPoint,
  radius_px: number,
  fill: string,
  { colour, width_px }: Pen,
): void {
  context.beginPath();
  context.arc(x, y, radius_px, 0, 2 * Math.PI);
  context.fillStyle = fill;
  context.fill();
  strokeTwice(context, colour, width_px);
}

/** Right of a place, above it. */
export function drawText(
  context: CanvasRenderingContext2D,
  words: string,
  { x, y }: ScreenPoint,
  colour: string,
): void {
  context.font = FONT;
  context.lineJoin = "round";
  context.strokeStyle = EDGE;
  context.lineWidth = 3;
  context.strokeText(words, x, y);
  context.fillStyle = colour;
  context.fillText(words, x, y);
}

function strokeTwice(context: CanvasRenderingContext2D, colour: string, width_px: number): void {
  context.strokeStyle = EDGE;
  context.lineWidth = width_px + 2;
  context.stroke();
  context.strokeStyle = colour;
  context.lineWidth = width_px;
  context.stroke();
}
