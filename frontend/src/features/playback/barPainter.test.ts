import { describe, expect, test } from "vitest";
import { aFlightEvent } from "../../test/flights";
import { type BarPicture, paintBar } from "./barPainter";
import { LANES } from "./flightLanes";

const [WIDTH, HEIGHT] = [600, 80];
const STARTS_S = 1_699_956_000;
const LANE_COLOURS = Object.fromEntries(LANES.map((lane) => [lane, lane])) as BarPicture["colours"]["lane"];
const COLOURS = {
  ground: "ground",
  outline: "outline",
  gap: "gap",
  tick: "tick",
  text: "text",
  loop: "loop",
  lane: LANE_COLOURS,
};

interface Drawn {
  /** Filled boxes with the colour of each: left, top, width, height. */
  readonly boxes: ReadonlyArray<readonly [string, number, number, number, number]>;
  /** The filled areas, point by point. */
  readonly areas: ReadonlyArray<ReadonlyArray<readonly [number, number]>>;
  readonly texts: readonly string[];
  /** Where hatching was clipped to: left and width. */
  readonly hatched: ReadonlyArray<readonly [number, number]>;
}

/** What is painted of a flight of 600 s in a bar of 600 px: a second is a pixel. */
function paint(parts: Partial<BarPicture> = {}): Drawn {
  const boxes: Array<readonly [string, number, number, number, number]> = [];
  const areas: Array<ReadonlyArray<readonly [number, number]>> = [];
  const texts: string[] = [];
  const hatched: Array<readonly [number, number]> = [];
  let path: Array<readonly [number, number]> = [];
  let clip: readonly [number, number] = [0, WIDTH];
  const context = {
    fillStyle: "",
    beginPath: () => {
      path = [];
    },
    moveTo: (x: number, y: number) => path.push([x, y]),
    lineTo: (x: number, y: number) => path.push([x, y]),
    rect: (x: number, _top: number, width: number) => {
      clip = [x, width];
    },
    clip: () => hatched.push(clip),
    fill: () => areas.push(path),
    fillRect: (...box: [number, number, number, number]) => boxes.push([context.fillStyle, ...box]),
    fillText: (text: string) => texts.push(text),
    clearRect: () => undefined,
    closePath: () => undefined,
    stroke: () => undefined,
    save: () => undefined,
    restore: () => undefined,
  };
  paintBar(context as unknown as CanvasRenderingContext2D, {
    width: WIDTH,
    height: HEIGHT,
    view: { from_s: 0, to_s: 600 },
    edge_s: 600,
    overview: null,
    events: [],
    starts_s: STARTS_S,
    loop: null,
    isThin: false,
    colours: COLOURS,
    font: "12px mono",
    fontSize_px: 12,
    ...parts,
  });
  return { boxes, areas, texts, hatched };
}

function overview(altitude_ft: Array<number | null>, gaps: number[][] = []) {
  return { duration_s: 600, signal: "gps.altitude_m", altitude_ft, gaps } as BarPicture["overview"];
}

describe("the altitude in the time bar", () => {
  test("is not drawn while it is not known", () => {
    expect(paint().areas).toEqual([]);
    expect(paint({ overview: overview([]) }).areas).toEqual([]);
    expect(paint({ overview: overview([null, null]) }).areas).toEqual([]);
  });

  test("is higher on the screen where the aircraft was higher", () => {
    const [area = []] = paint({ overview: overview([0, 1000, 500]) }).areas;
    const tops = area.slice(1, -1);
    expect(tops.map(([x]) => x)).toEqual([0, 300, 600]);
    const [low = 0, high = 0, middle = 0] = tops.map(([, y]) => y);
    expect(high).toBeLessThan(middle);
    expect(middle).toBeLessThan(low);
  });

  test("is broken where it is missing: nothing is drawn over what is not known", () => {
    const { areas } = paint({ overview: overview([100, 200, null, 300, 400]) });
    expect(areas.map((area) => area.slice(1, -1).map(([x]) => x))).toEqual([
      [0, 150],
      [450, 600],
    ]);
  });

  test("of a flat flight does not look like a mountain", () => {
    const climbOf = (highest_ft: number): number => {
      const [area = []] = paint({ overview: overview([0, highest_ft]) }).areas;
      return (area[1]?.[1] ?? 0) - (area[2]?.[1] ?? 0);
    };
    expect(climbOf(20)).toBeCloseTo(climbOf(200) / 10);
    expect(climbOf(2000)).toBeCloseTo(climbOf(200));
  });
});

describe("a stretch without data", () => {
  test("is hatched from its begin to its end, and a short one can still be seen", () => {
    expect(
      paint({
        overview: overview(
          [],
          [
            [100, 160],
            [300, 300.1],
          ],
        ),
      }).hatched,
    ).toEqual([
      [100, 60],
      [300, 2],
    ]);
  });

  test("is cut at the edges of the view, and left out beyond them", () => {
    const view = { from_s: 100, to_s: 700 };
    const gaps = [
      [0, 50],
      [50, 150],
      [650, 900],
      [800, 900],
    ];
    expect(paint({ view, overview: overview([], gaps) }).hatched).toEqual([
      [0, 50],
      [550, 50],
    ]);
  });
});

describe("an event", () => {
  const alarm = aFlightEvent({ kind: "alarm", at_s: 200, t_s: STARTS_S + 200, until_s: STARTS_S + 230 });
  const command = aFlightEvent({ kind: "command", at_s: 60 });
  const mark = aFlightEvent({ kind: "mark", at_s: 400 });

  test("stands in the lane of its kind for as long as it lasted", () => {
    const { boxes } = paint({ events: [command, alarm] });
    expect(boxes.map(([colour, left, , width]) => [colour, left, Math.round(width)])).toEqual([
      ["command", 59, 2],
      ["alarm", 199, 30],
    ]);
    const [first, second] = boxes.map(([, , top]) => top);
    expect(second).toBeGreaterThan(first ?? Number.POSITIVE_INFINITY);
  });

  test("is as long before the flight's start is known", () => {
    const width = ({ boxes }: Drawn) => boxes[0]?.[3];
    expect(width(paint({ events: [alarm], starts_s: null }))).toBe(width(paint({ events: [alarm] })));
  });

  test("that is a mark is drawn over the altitude, too", () => {
    const { boxes } = paint({ events: [mark] });
    expect(boxes).toHaveLength(2);
    expect(boxes[1]?.slice(0, 4)).toEqual(["mark", 399, 0, 1]);
  });

  test("outside of the view, or without a lane, is not drawn", () => {
    const view = { from_s: 250, to_s: 300 };
    const gap = aFlightEvent({ kind: "gap", at_s: 270 });
    expect(paint({ view, events: [command, alarm, mark, gap] }).boxes).toEqual([]);
  });

  test("is drawn once where thousands of its kind would cover each other, and none of them is left out", () => {
    const events = Array.from({ length: 6000 }, (_, tenth) =>
      aFlightEvent({ kind: "command", at_s: tenth / 10 }),
    );
    const { boxes } = paint({ events });
    expect(boxes.length).toBeLessThan(1300);
    const gaps = boxes
      .slice(1)
      .map(([, left], index) => left - ((boxes[index]?.[1] ?? 0) + (boxes[index]?.[3] ?? 0)));
    expect(Math.max(...gaps)).toBeLessThan(0.2);
    expect((boxes.at(-1)?.[1] ?? 0) + 2).toBeGreaterThan(599);
  });

  test("is drawn in the thin bar of the present only if one looks back for it", () => {
    const { boxes, texts } = paint({ isThin: true, events: [command, alarm, mark] });
    expect(new Set(boxes.map(([colour]) => colour))).toEqual(new Set(["alarm", "mark"]));
    expect(texts).toEqual([]);
  });
});

test("the stretch that is repeated is marked, however short it is", () => {
  expect(paint({ loop: [100, 130] }).boxes).toEqual([["loop", 100, 0, 30, 3]]);
  expect(paint({ loop: [100, 100.1] }).boxes).toEqual([["loop", 100, 0, 2, 3]]);
});

test("the axis has round times of the flight, and tenths where it is zoomed in", () => {
  expect(paint().texts).toEqual(["0:00", "2:00", "4:00", "6:00", "8:00", "10:00"]);
  expect(paint({ view: { from_s: 60, to_s: 64 } }).texts.slice(0, 2)).toEqual(["1:00.0", "1:01.0"]);
});
