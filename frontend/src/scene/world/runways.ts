import { METRES_PER_FOOT } from "../../lib/units";
import type { GroundLook } from "../look";
import type { RunwayOf } from "./cell";

/** Smallest width of a runway in pixels: it would be invisible at small scales. */
const LEAST_WIDTH_PX = 2.5;
/** Markings are painted from this many pixels of width, on hard surfaces. */
const MARKED_WIDTH_PX = 9;
/** For those whose width the source does not say. */
const USUAL_WIDTH_M = 25;
/** Nearer than this nobody lands: the source has both ends in one place. */
const LEAST_LENGTH_M = 20;
/** Dashed centre line: stripe, gap, and where it begins. */
const STRIPE_M = 30;
const GAP_M = 20;
const BEGIN_M = 120;
/** Bars at the threshold, and the number behind them. */
const BAR_M = 30;
const BAR_WIDTH_M = 1.8;
const NUMBER_AT_M = 60;
const NUMBER_HEIGHT_M = 18;

interface Spot {
  readonly x: number;
  readonly y: number;
}

/** Draw one runway between both ends as they are on the canvas. */
export function drawRunway(
  context: OffscreenCanvasRenderingContext2D,
  runway: RunwayOf,
  [from, to]: readonly Spot[],
  look: GroundLook,
): void {
  const length_m = runwayLength_m(runway);
  if (from === undefined || to === undefined || !(length_m > LEAST_LENGTH_M)) {
    return;
  }
  const length_px = Math.hypot(to.x - from.x, to.y - from.y);
  const metre_px = length_px / length_m;
  const true_m = runway.width_ft === null ? USUAL_WIDTH_M : runway.width_ft * METRES_PER_FOOT;
  const width_m = Math.max(true_m, LEAST_WIDTH_PX / metre_px);
  context.save();
  // In metres: x from the middle towards its second end, y to the right of that.
  context.translate((from.x + to.x) / 2, (from.y + to.y) / 2);
  context.rotate(Math.atan2(to.y - from.y, to.x - from.x));
  context.scale(metre_px, metre_px);
  context.fillStyle = surfaceOf(runway.surface, look);
  context.fillRect(-length_m / 2, -width_m / 2, length_m, width_m);
  const isHard = runway.surface === "asphalt" || runway.surface === "concrete";
  if (isHard && true_m * metre_px >= MARKED_WIDTH_PX) {
    drawMarks(context, runway, length_m, true_m, look);
  }
  context.restore();
}

/** Between both ends, on the ground; where the source does not place them, the length it tells. */
export function runwayLength_m({ places, length_ft }: RunwayOf): number {
  if (places === null) {
    return (length_ft ?? 0) * METRES_PER_FOOT;
  }
  const [one, other] = places;
  const across = Math.cos((one.latitude_deg * Math.PI) / 180);
  const [east, north] = [
    (other.longitude_deg - one.longitude_deg) * across,
    other.latitude_deg - one.latitude_deg,
  ];
  return 111_195 * Math.hypot(east, north);
}

function surfaceOf(surface: string, look: GroundLook): string {
  switch (surface) {
    case "grass":
    case "earth":
      return look.grass;
    case "water":
    case "snow":
      return look.water;
    default:
      return look.asphalt;
  }
}

function drawMarks(
  context: OffscreenCanvasRenderingContext2D,
  { ends }: RunwayOf,
  length_m: number,
  width_m: number,
  look: GroundLook,
): void {
  context.fillStyle = look.paint;
  for (let x = BEGIN_M - length_m / 2; x + STRIPE_M < length_m / 2 - BEGIN_M; x += STRIPE_M + GAP_M) {
    context.fillRect(x, -0.5, STRIPE_M, 1);
  }
  for (const side of [-1, 1]) {
    context.fillRect(-length_m / 2, (side * (width_m - 3)) / 2 - 0.45, length_m, 0.9);
  }
  ends.forEach((name, index) => {
    context.save();
    if (index === 1) {
      context.rotate(Math.PI);
    }
    context.translate(-length_m / 2, 0);
    for (let y = -width_m / 2 + 4; y < width_m / 2 - 4; y += 2 * BAR_WIDTH_M) {
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
