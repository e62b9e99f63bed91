import { EARTH_RADIUS_M } from "../../lib/geodesy";
import type { Spot } from "../../lib/labels";
import type { Light } from "../look";

/** Where the edge of the Earth is on the picture: a circle around a middle on the Earth's side. */
export interface Horizon {
  readonly middle: Spot;
  readonly radius_px: number;
}

/** A stop of the sky: so many degrees above the horizon. */
type Stop = readonly [above_deg: number, colour: string];

const LOW: Readonly<Record<Light, readonly Stop[]>> = {
  day: [
    [0, "#d9e6ee"],
    [1.5, "#c0d8ea"],
    [7, "#86b3db"],
    [25, "#3f79bb"],
    [60, "#1f4f92"],
  ],
  night: [
    [0, "#26364a"],
    [2, "#1b2a40"],
    [10, "#101c30"],
    [35, "#080f1e"],
    [60, "#050a15"],
  ],
};
const SPACE: Readonly<Record<Light, readonly Stop[]>> = {
  day: [
    [0, "#cfe4f2"],
    [0.6, "#7fb4e4"],
    [2.2, "#2a62ac"],
    [5, "#0c1e3c"],
    [12, "#04070d"],
  ],
  night: [
    [0, "#2b4666"],
    [0.6, "#1a2f4c"],
    [2.2, "#0c1728"],
    [5, "#050a12"],
    [12, "#020408"],
  ],
};
const HAZE: Readonly<Record<Light, string>> = { day: "200 219 232", night: "24 36 52" };
/** The air takes two thirds of the view at this distance. */
const CLEAR_M = 130_000;
/** Seen so far below the horizon, degrees, the ground is clear. */
const HAZE_STEPS_DEG = [0, 0.25, 0.8, 2, 5, 12] as const;
/** The haze ends within so many pixels of the horizon. */
const EDGE_PX = 1.5;
/** A horizon of a greater radius is drawn straight. */
const STRAIGHT_PX = 6000;
/** From here on the sky is that of space, below that of a day on the ground. */
const SPACE_M = 400_000;
const LOW_M = 15_000;

/** The circle through three points of the Earth's edge; null if one is not in front of the camera. */
export function horizonThrough(points: readonly (Spot | null)[], below: Spot): Horizon | null {
  const [a, b, c] = points;
  if (!(a && b && c)) {
    return null;
  }
  const d = 2 * (a.x * (b.y - c.y) + b.x * (c.y - a.y) + c.x * (a.y - b.y));
  const span = Math.hypot(b.x - c.x, b.y - c.y);
  if (Math.abs(d) > 1e-4 * span * span) {
    const [aa, bb, cc] = [a, b, c].map(({ x, y }) => x * x + y * y) as [number, number, number];
    const middle = {
      x: (aa * (b.y - c.y) + bb * (c.y - a.y) + cc * (a.y - b.y)) / d,
      y: (aa * (c.x - b.x) + bb * (a.x - c.x) + cc * (b.x - a.x)) / d,
    };
    return { middle, radius_px: Math.hypot(a.x - middle.x, a.y - middle.y) };
  }
  // Straight, as far as is seen: a circle so large that nobody sees its curve.
  const radius_px = 20 * span;
  const [across_x, across_y] = [(c.x - b.x) / span, (c.y - b.y) / span];
  const side = (below.x - a.x) * -across_y + (below.y - a.y) * across_x > 0 ? 1 : -1;
  return {
    middle: { x: a.x - side * across_y * radius_px, y: a.y + side * across_x * radius_px },
    radius_px,
  };
}

/** Fill the picture with sky; `degree_px`: pixels of a degree. Null: no horizon is seen. */
export function paintSky(
  context: CanvasRenderingContext2D,
  horizon: Horizon | null,
  degree_px: number,
  height_m: number,
  light: Light,
): void {
  const { width, height } = context.canvas;
  const share = Math.min(1, Math.max(0, Math.log(height_m / LOW_M) / Math.log(SPACE_M / LOW_M)));
  if (horizon === null) {
    context.fillStyle = (share > 0.5 ? SPACE : LOW)[light].at(-1)?.[1] ?? "";
    context.fillRect(0, 0, width, height);
    return;
  }
  const low = LOW[light];
  const space = SPACE[light];
  const last_deg = mixed(low.at(-1)?.[0] ?? 0, space.at(-1)?.[0] ?? 0, share);
  const fill = gradient(context, horizon, 0, last_deg * degree_px);
  low.forEach(([above_deg, colour], index) => {
    const other = space[index] ?? [above_deg, colour];
    const at = mixed(above_deg, other[0], share) / last_deg;
    fill.addColorStop(
      Math.min(1, at),
      `color-mix(in srgb, ${other[1]} ${(100 * share).toFixed(1)}%, ${colour})`,
    );
  });
  context.fillStyle = fill;
  context.fillRect(0, 0, width, height);
}

/** The air between the eye and the ground, over the picture: the nearer to the horizon the thicker. */
export function paintHaze(
  context: CanvasRenderingContext2D,
  horizon: Horizon,
  degree_px: number,
  height_m: number,
  light: Light,
): void {
  const depth_px = Math.min((HAZE_STEPS_DEG.at(-1) ?? 0) * degree_px, 0.9 * horizon.radius_px);
  const haze = gradient(context, horizon, -depth_px, EDGE_PX);
  const reach_px = depth_px + EDGE_PX;
  for (const below_deg of [...HAZE_STEPS_DEG].reverse()) {
    const at = (depth_px - below_deg * degree_px) / reach_px;
    if (at >= 0) {
      const share = hazeAt(below_deg, height_m) - hazeAt(HAZE_STEPS_DEG.at(-1) ?? 0, height_m);
      haze.addColorStop(at, `rgb(${HAZE[light]} / ${(100 * share).toFixed(1)}%)`);
    }
  }
  // Nothing over the sky.
  haze.addColorStop(1, `rgb(${HAZE[light]} / 0%)`);
  context.fillStyle = haze;
  context.fillRect(0, 0, context.canvas.width, context.canvas.height);
}

/** From so many pixels above the horizon to so many; below it they are negative. */
function gradient(
  context: CanvasRenderingContext2D,
  { middle, radius_px }: Horizon,
  from_px: number,
  to_px: number,
): CanvasGradient {
  if (radius_px < STRAIGHT_PX) {
    const [from, to] = [Math.max(0, radius_px + from_px), radius_px + to_px];
    return context.createRadialGradient(middle.x, middle.y, from, middle.x, middle.y, to);
  }
  // The graphics reckon with few digits: so large a circle is a straight line in the picture.
  const { width, height } = context.canvas;
  const [right, down] = [width / 2 - middle.x, height / 2 - middle.y];
  const away = Math.hypot(right, down);
  const [out_x, out_y] = [right / away, down / away];
  const on = { x: middle.x + radius_px * out_x, y: middle.y + radius_px * out_y };
  return context.createLinearGradient(
    on.x + from_px * out_x,
    on.y + from_px * out_y,
    on.x + to_px * out_x,
    on.y + to_px * out_y,
  );
}

/** How much of the ground's light is lost on its way, 0..1, so many degrees below the horizon. */
export function hazeAt(below_deg: number, height_m: number): number {
  const top = EARTH_RADIUS_M + Math.max(1, height_m);
  const dip = Math.acos(EARTH_RADIUS_M / top);
  const depression = dip + (below_deg * Math.PI) / 180;
  const along = top * Math.sin(depression);
  const under = along * along - (top * top - EARTH_RADIUS_M * EARTH_RADIUS_M);
  const distance_m = along - Math.sqrt(Math.max(0, under));
  // The air is thin above a few kilometres: seen from high up only a part of the way is in it.
  const inAir = Math.min(1, 12_000 / Math.max(12_000, height_m));
  const most = height_m > SPACE_M ? 0.35 : 0.75;
  return most * (1 - Math.exp((-distance_m * Math.max(0.12, inAir)) / CLEAR_M));
}

function mixed(one: number, other: number, share: number): number {
  return one + (other - one) * share;
}
