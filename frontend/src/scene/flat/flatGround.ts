import { METRES_PER_DEGREE } from "../../lib/geodesy";
import { ASPHALT, COAST, LAND, PAINT, SEA } from "../colours";
import { GRAN_CANARIA, runwayCourse } from "../globe/chart/airfields";
import type { Island } from "../globe/chart/coast";
import { overlaps, thinned } from "../globe/chart/geometry";
import { boxSeen, type FlatView, metresPerPixel, toScreen } from "./projection";
import type { Words } from "./Words";

/** Sea and islands. */
export function drawGround(
  context: CanvasRenderingContext2D,
  view: FlatView,
  islands: readonly Island[],
): void {
  context.fillStyle = SEA;
  context.fillRect(0, 0, view.width_px, view.height_px);
  const seen = boxSeen(view);
  const pixel_deg = metresPerPixel(view) / METRES_PER_DEGREE;
  context.beginPath();
  for (const { ring } of islands.filter(({ box }) => overlaps(box, seen))) {
    thinned(ring, pixel_deg / 2).forEach(([longitude_deg, latitude_deg], index) => {
      const { x, y } = toScreen(view, { latitude_deg, longitude_deg });
      if (index === 0) {
        context.moveTo(x, y);
      } else {
        context.lineTo(x, y);
      }
    });
    context.closePath();
  }
  context.fillStyle = LAND;
  context.fill();
  context.strokeStyle = COAST;
  context.lineWidth = 1.5;
  context.stroke();
}

/** The field's code stands beside it while the runway is no shorter than this on the screen, and no longer. */
const CODE_LENGTH_PX = [14, 400] as const;

/** The runways of the station's airfield, over the pictures too: those may be years old. */
export function drawRunways(context: CanvasRenderingContext2D, view: FlatView, words: Words): void {
  context.strokeStyle = ASPHALT;
  for (const { ends, width_m } of GRAN_CANARIA.runways) {
    const [from, to] = ends.map((end) => toScreen(view, end));
    if (from !== undefined && to !== undefined) {
      context.lineWidth = Math.max(2, width_m / metresPerPixel(view));
      context.beginPath();
      context.moveTo(from.x, from.y);
      context.lineTo(to.x, to.y);
      context.stroke();
    }
  }
  const [first] = GRAN_CANARIA.runways;
  const length_px = first === undefined ? 0 : runwayCourse(first).length_m / metresPerPixel(view);
  if (length_px > CODE_LENGTH_PX[0] && length_px < CODE_LENGTH_PX[1]) {
    words.write(GRAN_CANARIA.code, toScreen(view, GRAN_CANARIA), 8 + length_px * 0.22, PAINT);
  }
}
