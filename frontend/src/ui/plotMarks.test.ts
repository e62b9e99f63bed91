import { expect, test } from "vitest";
import { drawMarks, type PlotMark } from "./plotMarks";

/** One second is ten pixels, a letter six wide. */
function drawn(marks: readonly PlotMark[]): readonly (readonly [string, ...unknown[]])[] {
  const calls: (readonly [string, ...unknown[]])[] = [];
  const known: Record<string, unknown> = { measureText: (text: string) => ({ width: 6 * text.length }) };
  const ctx = new Proxy(known, {
    get: (_, name: string) => known[name] ?? ((...given: unknown[]) => void calls.push([name, ...given])),
    set: () => true,
  }) as unknown as CanvasRenderingContext2D;
  drawMarks(
    { ctx, bbox: { left: 0, top: 0, width: 300, height: 100 }, valToPos: (before_s) => 300 + 10 * before_s },
    marks,
    { text: "white", ground: "black", font: "10px mono", ratio: 1 },
  );
  return calls;
}

const TWO: readonly PlotMark[] = [
  { before_s: -20, label: "k_roll 2 → 6" },
  { before_s: -18.5, label: "k_roll 6 → 2" },
];

test("the line of a change within two seconds does not go through the label of the one before", () => {
  const names = drawn(TWO).map(([name]) => name);
  expect(names.lastIndexOf("stroke")).toBeLessThan(names.indexOf("fillRect"));
  const boxes = drawn(TWO).filter(([name]) => name === "fillRect");
  const [from = 0, top = 0, width = 0, height = 0] = (boxes[0]?.slice(1) ?? []) as number[];
  expect([from <= 104, from + width >= 104 + 72, top < 12, top + height > 12]).toEqual([
    true,
    true,
    true,
    true,
  ]);
});

test("labels stand in the first row that is free, however many come together", () => {
  const marks = [-20, -19, -18, -17, 0].map((before_s) => ({ before_s, label: "k_roll 2 → 6" }));
  const rows = drawn(marks).flatMap(([name, , , y]) =>
    name === "fillText" ? [Math.round(Number(y) / 12)] : [],
  );
  expect(rows).toEqual([1, 2, 3, 4, 1]);
});
