import { EDGE } from "../colours";
import type { ScreenPoint } from "./projection";

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

function strokeTwice(context: CanvasRenderingContext2D, colour: string, width_px: number): void {
  context.strokeStyle = EDGE;
  context.lineWidth = width_px + 2;
  context.stroke();
  context.strokeStyle = colour;
  context.lineWidth = width_px;
  context.stroke();
}
