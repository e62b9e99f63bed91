import { describe, expect, test } from "vitest";
import { type Horizon, hazeAt, horizonThrough, paintHaze, paintSky } from "./sky";

interface SkyStroke {
  readonly kind: "circle" | "straight" | "plain";
  /** As the canvas was given them. */
  readonly ends: readonly number[];
  readonly stops: ReadonlyArray<readonly [at: number, colour: string]>;
  readonly colour: string;
  readonly filled: readonly number[];
}

/** A picture that remembers with what it was filled. */
function picture(width = 800, height = 600) {
  const painted: SkyStroke[] = [];
  const gradient = (kind: SkyStroke["kind"], ends: readonly number[]) => {
    const stops: [number, string][] = [];
    return {
      kind,
      ends,
      stops,
      addColorStop: (at: number, colour: string) => {
        // A canvas refuses any other.
        if (!(at >= 0 && at <= 1)) {
          throw new RangeError(`a stop at ${at}`);
        }
        stops.push([at, colour]);
      },
    };
  };
  const context = {
    canvas: { width, height },
    fillStyle: "" as string | ReturnType<typeof gradient>,
    createRadialGradient: (...ends: number[]) => gradient("circle", ends),
    createLinearGradient: (...ends: number[]) => gradient("straight", ends),
    fillRect: (...filled: number[]) => {
      const style = context.fillStyle;
      painted.push(
        typeof style === "string"
          ? { kind: "plain", ends: [], stops: [], colour: style, filled }
          : { kind: style.kind, ends: style.ends, stops: style.stops, colour: "", filled },
      );
    },
  };
  const only = (): SkyStroke => {
    expect(painted).toHaveLength(1);
    const [one] = painted;
    if (one === undefined) {
      throw new Error("nothing was painted");
    }
    expect(one.filled).toEqual([0, 0, width, height]);
    return one;
  };
  return { context: context as unknown as CanvasRenderingContext2D, only };
}

const ROUND: Horizon = { middle: { x: 400, y: 900 }, radius_px: 700 };
const STRAIGHT: Horizon = { middle: { x: 400, y: 100_300 }, radius_px: 100_000 };

function on(degrees: number, { middle, radius_px } = ROUND) {
  const angle = (degrees * Math.PI) / 180;
  return { x: middle.x + radius_px * Math.cos(angle), y: middle.y + radius_px * Math.sin(angle) };
}

describe("the horizon", () => {
  test("is the circle on which all three points of the Earth's edge lie", () => {
    const found = horizonThrough([on(-90), on(-120), on(-60)], { x: 400, y: 900 });
    expect(found?.middle.x).toBeCloseTo(400, 6);
    expect(found?.middle.y).toBeCloseTo(900, 6);
    expect(found?.radius_px).toBeCloseTo(700, 6);
  });

  test("is not known while one of its points is behind the camera", () => {
    const ground = { x: 0, y: 500 };
    expect(horizonThrough([on(-90), null, on(-60)], ground)).toBeNull();
    expect(horizonThrough([null, on(-90), on(-60)], ground)).toBeNull();
    expect(horizonThrough([on(-90), on(-60)], ground)).toBeNull();
  });

  test.each([
    ["below", 500, 1],
    ["above", 100, -1],
  ])("that is straight has the Earth's middle on the side of the ground: %s", (_, ground_y, side) => {
    const points = [
      { x: 400, y: 300 },
      { x: 0, y: 300 },
      { x: 800, y: 300 },
    ];
    const found = horizonThrough(points, { x: 400, y: ground_y });
    expect(found?.middle.x).toBeCloseTo(400, 6);
    expect(((found?.middle.y ?? 0) - 300) * side).toBeCloseTo(16_000, 6);
    expect(found?.radius_px).toBe(16_000);
  });
});

describe("the sky", () => {
  test("begins at the edge of the Earth and ends sixty degrees above it for an aircraft", () => {
    const { context, only } = picture();
    paintSky(context, ROUND, 10, 300, "day");
    const { kind, ends, stops } = only();
    expect(kind).toBe("circle");
    expect(ends).toEqual([400, 900, 700, 400, 900, 1300]);
    expect(stops[0]?.[0]).toBe(0);
    expect(stops.at(-1)?.[0]).toBe(1);
    expect(stops.map(([at]) => at)).toEqual(stops.map(([at]) => at).sort((one, other) => one - other));
    expect(stops[0]?.[1]).toContain("0.0%, #d9e6ee");
  });

  test("is that of space from 400 km on, thin above the edge", () => {
    const { context, only } = picture();
    paintSky(context, ROUND, 10, 2_000_000, "day");
    const { ends, stops } = only();
    expect(ends.at(-1)).toBe(700 + 12 * 10);
    expect(stops.every(([, colour]) => colour.includes(" 100.0%, "))).toBe(true);
  });

  test("turns to that of space bit by bit between", () => {
    const { context, only } = picture();
    // Half way in the logarithm.
    paintSky(context, ROUND, 10, Math.sqrt(15_000 * 400_000), "night");
    const { ends, stops } = only();
    expect(ends.at(-1)).toBeCloseTo(700 + 36 * 10, 6);
    expect(stops[0]?.[1]).toContain(" 50.0%, ");
  });

  test("along a horizon without a curve is painted straight up from it", () => {
    const { context, only } = picture();
    paintSky(context, STRAIGHT, 10, 300, "day");
    const { kind, ends } = only();
    expect(kind).toBe("straight");
    const [from_x = 0, from_y = 0, to_x = 0, to_y = 0] = ends;
    expect(from_x).toBeCloseTo(400, 6);
    expect(from_y).toBeCloseTo(300, 6);
    expect(to_x).toBeCloseTo(400, 6);
    expect(to_y).toBeCloseTo(-300, 6);
  });

  test("without a horizon has one colour, darker in space and at night", () => {
    const colours = [
      [300, "day"],
      [2_000_000, "day"],
      [300, "night"],
    ].map(([height_m, light]) => {
      const { context, only } = picture();
      paintSky(context, null, 10, Number(height_m), light === "night" ? "night" : "day");
      expect(only().kind).toBe("plain");
      return only().colour;
    });
    expect(colours).toEqual(["#1f4f92", "#04070d", "#050a15"]);
  });
});

describe("the haze", () => {
  function shares(painted: SkyStroke): number[] {
    return painted.stops.map(([, colour]) => Number(/([\d.]+)%/.exec(colour)?.[1]));
  }

  test("grows towards the horizon, and none lies over the sky or on the ground below", () => {
    const { context, only } = picture();
    paintHaze(context, ROUND, 10, 300, "day");
    const painted = only();
    const found = shares(painted);
    expect(found[0]).toBe(0);
    expect(found.at(-1)).toBe(0);
    const ground = found.slice(0, -1);
    expect(ground).toEqual([...ground].sort((one, other) => one - other));
    expect(Math.max(...ground)).toBeGreaterThan(20);
    expect(painted.ends[5]).toBeCloseTo(701.5, 6);
  });

  test("of a small Earth never reaches past its middle, and leaves out what would", () => {
    const { context, only } = picture();
    const ball = { middle: { x: 400, y: 300 }, radius_px: 100 };
    paintHaze(context, ball, 20, 5_000_000, "day");
    const painted = only();
    expect(painted.ends[2]).toBeCloseTo(10, 6);
    // Five and twelve degrees below the edge lie beyond the ground that is left.
    expect(painted.stops).toHaveLength(4 + 1);
  });

  test("is dark at night", () => {
    const [day, night] = (["day", "night"] as const).map((light) => {
      const { context, only } = picture();
      paintHaze(context, STRAIGHT, 10, 300, light);
      return only().stops[0]?.[1];
    });
    expect(day).toContain("200 219 232");
    expect(night).toContain("24 36 52");
  });

  test("takes less of the ground the steeper it is looked at", () => {
    const found = [0, 0.25, 0.8, 2, 5, 12, 90].map((below_deg) => hazeAt(below_deg, 1000));
    expect(found).toEqual([...found].sort((one, other) => other - one));
    expect(found[0]).toBeGreaterThan(0.3);
    // Straight down through one kilometre.
    expect(found.at(-1)).toBeLessThan(0.02);
  });

  test("never hides the Earth's edge from space as it does from an aircraft", () => {
    expect(hazeAt(0, 1_000_000)).toBeLessThanOrEqual(0.35);
    expect(hazeAt(0, 10_000)).toBeGreaterThan(0.35);
  });

  test("has a number on the ground and below the sea too", () => {
    expect(hazeAt(0, 0)).toBeGreaterThan(0);
    expect(hazeAt(0, -50)).toBe(hazeAt(0, 0));
  });
});
