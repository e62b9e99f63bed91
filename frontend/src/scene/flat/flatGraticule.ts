import { angleText, type CompassLetters, graticuleStep_s, linesBetween_s } from "../globe/chart/graticule";
import { GRATICULE_TEXT } from "../lettering";
import { boxSeen, type FlatView, toScreen } from "./projection";
import type { Words } from "./Words";

const LINE = "rgb(255 255 255 / 34%)";
/** From the bottom and from the left: the scale and the buttons stand in the corners. */
const EDGE_PX = 44;

/** Lines of latitude and longitude, each with its angle, as on the globe. */
export function drawGraticule(
  context: CanvasRenderingContext2D,
  view: FlatView,
  letters: CompassLetters,
  words: Words,
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
  // Each line is named once, near the picture's edge, where it does not meet another name.
  for (const { x, name } of meridians) {
    words.add({ ...GRATICULE_TEXT, key: `m${name}`, text: name, at: { x, y: view.height_px - EDGE_PX } });
  }
  for (const { y, name } of parallels) {
    words.add({ ...GRATICULE_TEXT, key: `p${name}`, text: name, at: { x: EDGE_PX, y } });
  }
}
