import { angleText, type CompassLetters, graticuleStep_s, linesBetween_s } from "../globe/chart/graticule";
import { boxSeen, type FlatView, toScreen } from "./projection";

const LINE = "rgb(255 255 255 / 34%)";
const INK = "rgb(255 255 255 / 88%)";
const EDGE = "rgb(8 20 30 / 75%)";
const FONT = '11px "B612 Mono", "DejaVu Sans Mono", monospace';
const GAP_PX = 4;

/** Lines of latitude and longitude, and at each crossing the two angles, as on the globe. */
export function drawGraticule(
  context: CanvasRenderingContext2D,
  view: FlatView,
  letters: CompassLetters,
): void {
  const box = boxSeen(view);
  // A tile of the globe's levels is half as wide as one of Web Mercator.
  const step_s = graticuleStep_s(Math.max(0, Math.floor(view.zoom) - 1));
  const meridians = linesBetween_s(box.west_deg, box.east_deg, step_s).map((angle_s) => ({
    x: toScreen(view, { latitude_deg: 0, longitude_deg: angle_s / 3600 }).x,
    name: angleText(angle_s, step_s, letters.east, letters.west),
  }));
  const parallels = linesBetween_s(box.south_deg, box.north_deg, step_s).map((angle_s) => ({
    y: toScreen(view, { latitude_deg: angle_s / 3600, longitude_deg: 0 }).y,
    name: angleText(angle_s, step_s, letters.north, letters.south),
  }));
  context.strokeStyle = LINE;
  context.lineWidth = 1;
  context.beginPath();
  for (const { x } of meridians) {
    context.moveTo(x, 0);
    context.lineTo(x, view.height_px);
  }
  for (const { y } of parallels) {
    context.moveTo(0, y);
    context.lineTo(view.width_px, y);
  }
  context.stroke();
  context.font = FONT;
  context.fillStyle = INK;
  context.strokeStyle = EDGE;
  context.lineWidth = 3;
  context.lineJoin = "round";
  for (const { x, name: longitude } of meridians) {
    for (const { y, name: latitude } of parallels) {
      context.strokeText(latitude, x + GAP_PX, y - GAP_PX);
      context.fillText(latitude, x + GAP_PX, y - GAP_PX);
      context.save();
      context.translate(x - GAP_PX, y - GAP_PX);
      context.rotate(-Math.PI / 2);
      context.strokeText(longitude, 0, 0);
      context.fillText(longitude, 0, 0);
      context.restore();
    }
  }
}
