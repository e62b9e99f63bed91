import type { Spot } from "../../lib/labels";
import { EDGE } from "../colours";

/** The signs of aeronautical charts, as far as they fit into a dozen pixels. */
export type Mark = "town" | "airfield" | "heliport" | "water" | "vor" | "ndb";

const RADIUS_PX = 5;

export function drawMark(
  context: CanvasRenderingContext2D,
  mark: Mark,
  { x, y }: Spot,
  colour: string,
): void {
  context.beginPath();
  trace(context, mark, x, y);
  context.strokeStyle = EDGE;
  context.lineWidth = mark === "town" ? 2 : 4;
  context.stroke();
  if (mark === "town") {
    context.fillStyle = colour;
    context.fill();
    return;
  }
  context.strokeStyle = colour;
  context.lineWidth = 1.6;
  if (mark === "ndb") {
    context.setLineDash([1.5, 2]);
  }
  context.stroke();
  context.setLineDash([]);
}

function trace(context: CanvasRenderingContext2D, mark: Mark, x: number, y: number): void {
  const radius = RADIUS_PX;
  switch (mark) {
    case "town":
      context.arc(x, y, 1.8, 0, 2 * Math.PI);
      break;
    case "airfield":
      context.arc(x, y, radius - 0.5, 0, 2 * Math.PI);
      context.moveTo(x - radius - 2, y + radius + 2);
      context.lineTo(x + radius + 2, y - radius - 2);
      break;
    case "heliport":
      context.moveTo(x - 3, y - 4);
      context.lineTo(x - 3, y + 4);
      context.moveTo(x - 3, y);
      context.lineTo(x + 3, y);
      context.moveTo(x + 3, y - 4);
      context.lineTo(x + 3, y + 4);
      break;
    case "water":
      context.arc(x, y, radius - 0.5, 0, Math.PI);
      context.moveTo(x, y - radius);
      context.lineTo(x, y + radius);
      break;
    case "vor":
      for (let corner = 0; corner <= 6; corner += 1) {
        const angle = (corner * Math.PI) / 3;
        context.lineTo(x + radius * Math.cos(angle), y + radius * Math.sin(angle));
      }
      break;
    case "ndb":
      context.arc(x, y, radius, 0, 2 * Math.PI);
      context.moveTo(x + 1, y);
      context.arc(x, y, 1, 0, 2 * Math.PI);
      break;
  }
}
