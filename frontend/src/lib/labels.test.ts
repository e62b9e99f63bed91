import { expect, test } from "vitest";
import { KEPT_RANK, meets, type PlacedLabel, placeLabels, sidesOf, type WantedLabel } from "./labels";

/** Numbers 0..1 that are the same in each run. */
function numbers(seed: number): () => number {
  let state = seed;
  return () => {
    state = (state * 1_664_525 + 1_013_904_223) % 4_294_967_296;
    return state / 4_294_967_296;
  };
}

/** So many labels on a picture of 900 by 600, crowded around some places as towns are. */
function crowd(seed: number, count: number): WantedLabel[] {
  const random = numbers(seed);
  return Array.from({ length: count }, (_, index) => ({
    key: `label ${index}`,
    rank: Math.round(200 * random()),
    at: { x: 900 * random() ** 2, y: 600 * random() },
    width: 20 + 120 * random(),
    height: 12 + 8 * random(),
    away_px: 4 + 8 * random(),
    isSought: random() < 0.1,
  }));
}

const NOBODY: ReadonlyMap<string, PlacedLabel> = new Map();
const SEEDS = Array.from({ length: 40 }, (_, index) => 7919 * (index + 1));

test.each(SEEDS)("no two boxes of a crowd meet (%i)", (seed) => {
  const placed = [...placeLabels(crowd(seed, 400), NOBODY).values()];
  expect(placed.length).toBeGreaterThan(30);
  const meeting = placed.filter((one, index) =>
    placed.some((other, at) => at > index && meets(one.box, other.box)),
  );
  expect(meeting).toEqual([]);
});

test.each(SEEDS)(
  "the more important stays: what is left out had only higher ones in its way (%i)",
  (seed) => {
    const wanted = crowd(seed, 300);
    const placed = placeLabels(wanted, NOBODY);
    const byKey = new Map(wanted.map((label) => [label.key, label]));
    const leftOut = wanted.filter(({ key }) => !placed.has(key));
    expect(leftOut.length).toBeGreaterThan(30);
    const withoutCause = leftOut.filter((label) => {
      const higher = [...placed].filter(([key]) => (byKey.get(key)?.rank ?? 0) >= label.rank);
      return !sidesOf(label).every((side) => higher.some(([, { box }]) => meets(side, box, 2)));
    });
    expect(withoutCause).toEqual([]);
  },
);

test.each(SEEDS)("a crowd that moves as one keeps every label on its side (%i)", (seed) => {
  const wanted = crowd(seed, 300);
  let placed = placeLabels(wanted, NOBODY);
  const first = [...placed].map(([key, { side }]) => `${key} ${side}`).sort();
  for (let step = 1; step <= 20; step += 1) {
    const moved = wanted.map((label) => ({
      ...label,
      at: { x: label.at.x + 3.7 * step, y: label.at.y - step },
    }));
    placed = placeLabels(moved, placed);
  }
  expect([...placed].map(([key, { side }]) => `${key} ${side}`).sort()).toEqual(first);
});

test("of two labels with room for one, the one that is shown stays until the other is clearly higher in rank", () => {
  // Whichever side each is on, the boxes meet: they begin at their places.
  const pair = (one: number, other: number): WantedLabel[] =>
    [one, other].map((rank, index) => ({
      key: `${index}`,
      rank,
      at: { x: 100 + index, y: 100 },
      width: 500,
      height: 300,
      away_px: 0,
      isSought: false,
    }));
  let placed = placeLabels(pair(10, 9), NOBODY);
  expect([...placed.keys()]).toEqual(["0"]);
  placed = placeLabels(pair(10, 10 + KEPT_RANK - 1), placed);
  expect([...placed.keys()]).toEqual(["0"]);
  placed = placeLabels(pair(10, 10 + KEPT_RANK + 1), placed);
  expect([...placed.keys()]).toEqual(["1"]);
});

test("what is taken is left free", () => {
  const taken = [{ left: 0, top: 0, right: 900, bottom: 300 }];
  const placed = placeLabels(crowd(11, 300), NOBODY, taken);
  expect(placed.size).toBeGreaterThan(10);
  expect([...placed.values()].some(({ box }) => meets(box, taken[0] ?? box))).toBe(false);
});

test("ten labels that must be read find room around one place", () => {
  const wanted = Array.from({ length: 10 }, (_, index) => ({
    key: `${index}`,
    rank: 1000,
    at: { x: 400, y: 300 },
    width: 90,
    height: 18,
    away_px: 10,
    isSought: true,
  }));
  expect(placeLabels(wanted, NOBODY).size).toBe(10);
});

test.each(SEEDS)(
  "no label is cut at the edge of the picture, and one that must be read looks for room (%i)",
  (seed) => {
    const within = { left: 0, top: 0, right: 900, bottom: 600 };
    const wanted = crowd(seed, 60);
    const placed = placeLabels(wanted, NOBODY, [], within);
    const cut = [...placed.values()].filter(
      ({ box }) => box.left < 0 || box.top < 0 || box.right > 900 || box.bottom > 600,
    );
    expect(cut).toEqual([]);
    expect(placed.size).toBeGreaterThan(20);
    const corner = {
      key: "corner",
      rank: 1,
      at: { x: 899, y: 1 },
      width: 90,
      height: 14,
      away_px: 6,
      isSought: true,
    };
    expect(placeLabels([corner], NOBODY, [], within).size).toBe(1);
  },
);
