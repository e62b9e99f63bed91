import { ASPHALT, PAINT } from "../../colours";
import { type Airfield, type Runway, runwayCourse } from "./airfields";
import { type Box, metresOfDegree, overlaps } from "./geometry";

/** Smallest width of a runway in pixels: it would be invisible at small scales. */
const LEAST_WIDTH_PX = 2.5;
/** Markings are painted from this many pixels of width. */
const MARKED_WIDTH_PX = 9;
/** A label is shown while the runway's length is within these pixels. */
const LABEL_LENGTH_PX = [14, 400] as const;
/** Dashed centre line: stripe, gap, and where it begins. */
const STRIPE_M = 30;
const GAP_M = 20;
const BEGIN_M = 120;
/** Bars at the threshold, and the number behind them. */
const BAR_M = 30;
const BAR_WIDTH_M = 1.8;
const NUMBER_AT_M = 60;
const NUMBER_HEIGHT_M = 18;

/** Draw the runways of a field that lie in a tile, and its code beside them at small scales. */
export function drawAirfield(context: CanvasRenderingContext2D, box: Box, field: Airfield): void {
  const pixel_deg = (box.east_deg - box.west_deg) / context.canvas.width;
  const { longitude_m, latitude_m } = metresOfDegree(field.latitude_deg);
  // At small scales the label extends over some tiles.
  const reach_deg = Math.max(0.03, 120 * pixel_deg);
  const reach: Box = {
    west_deg: field.longitude_deg - reach_deg,
    east_deg: field.longitude_deg + reach_deg,
    south_deg: field.latitude_deg - reach_deg,
    north_deg: field.latitude_deg + reach_deg,
  };
  if (!overlaps(reach, box)) {
    return;
  }
  for (const runway of field.runways) {
    drawRunway(context, box, runway, {
      longitude_px: 1 / (longitude_m * pixel_deg),
      latitude_px: 1 / (latitude_m * pixel_deg),
    });
  }
  context.resetTransform();
  const first = field.runways[0];
  const length_px = first === undefined ? 0 : runwayCourse(first).length_m / (latitude_m * pixel_deg);
  if (length_px > LABEL_LENGTH_PX[0] && length_px < LABEL_LENGTH_PX[1]) {
    const x = (field.longitude_deg - box.west_deg) / pixel_deg;
    const y = (box.north_deg - field.latitude_deg) / pixel_deg;
    context.font = `600 ${context.canvas.width / 19}px "Inter Variable", system-ui, sans-serif`;
    context.strokeStyle = "rgb(8 20 30 / 80%)";
    context.lineWidth = 3;
    context.lineJoin = "round";
    context.fillStyle = PAINT;
    const at_x = x + 8 + length_px * 0.22;
    context.strokeText(field.code, at_x, y + 4);
    context.fillText(field.code, at_x, y + 4);
  }
}

interface Scale {
  /** Pixels of one metre to the east, and to the north. */
  readonly longitude_px: number;
  readonly latitude_px: number;
}

/** Draws one runway in metres: x from the middle towards its second end, y to the right of that. */
function drawRunway(context: CanvasRenderingContext2D, box: Box, runway: Runway, scale: Scale): void {
  const pixel_deg = (box.east_deg - box.west_deg) / context.canvas.width;
  const { length_m, bearing_deg } = runwayCourse(runway);
  const [from, to] = runway.ends;
  const course = (bearing_deg * Math.PI) / 180;
  const { longitude_px, latitude_px } = scale;
  context.setTransform(
    Math.sin(course) * longitude_px,
    -Math.cos(course) * latitude_px,
    Math.cos(course) * longitude_px,
    Math.sin(course) * latitude_px,
    ((from.longitude_deg + to.longitude_deg) / 2 - box.west_deg) / pixel_deg,
    (box.north_deg - (from.latitude_deg + to.latitude_deg) / 2) / pixel_deg,
  );
  const width_m = Math.max(runway.width_m, LEAST_WIDTH_PX / latitude_px);
  context.fillStyle = ASPHALT;
  context.fillRect(-length_m / 2, -width_m / 2, length_m, width_m);
  if (runway.width_m * latitude_px < MARKED_WIDTH_PX) {
    return;
  }
  context.fillStyle = PAINT;
  for (let x = BEGIN_M - length_m / 2; x + STRIPE_M < length_m / 2 - BEGIN_M; x += STRIPE_M + GAP_M) {
    context.fillRect(x, -0.5, STRIPE_M, 1);
  }
  for (const side of [-1, 1]) {
    context.fillRect(-length_m / 2, (side * (runway.width_m - 3)) / 2 - 0.45, length_m, 0.9);
  }
  runway.ends.forEach(({ name }, index) => {
    context.save();
    if (index === 1) {
      context.rotate(Math.PI);
    }
    context.translate(-length_m / 2, 0);
    for (let y = -runway.width_m / 2 + 4; y < runway.width_m / 2 - 4; y += 2 * BAR_WIDTH_M) {
      context.fillRect(6, y, BAR_M, BAR_WIDTH_M);
    }
    // Upright as seen when landing.
    context.translate(NUMBER_AT_M, 0);
    context.rotate(Math.PI / 2);
    context.font = `700 ${NUMBER_HEIGHT_M}px "Inter Variable", system-ui, sans-serif`;
    context.textAlign = "center";
    context.textBaseline = "middle";
    context.fillText(name, 0, 0);
    context.restore();
  });
}
