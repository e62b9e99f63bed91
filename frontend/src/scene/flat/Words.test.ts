import { expect, test } from "vitest";
import { meets } from "../../lib/labels";
import { LabelSheet } from "../labels/LabelSheet";
import { Words } from "./Words";

const context = new Proxy({} as CanvasRenderingContext2D, {
  get: () => () => undefined,
  set: () => true,
});

/** Letters eight pixels wide, in lines 18 high. */
const letters = {
  sizeOf: ({ text }: { readonly text: string }) => ({ width: 8 * text.length, height: 18 }),
  draw: () => undefined,
};

/** Texts at one place of a picture of 800 by 600, painted. */
function written(texts: readonly string[], sheet = new LabelSheet(letters)): LabelSheet {
  const words = new Words();
  for (const text of texts) {
    words.write(text, { x: 400, y: 300 }, 8, "#fff");
  }
  words.paint(context, sheet, 800, 600, 1);
  return sheet;
}

test("the words of two things in one place do not stand over each other", () => {
  const boxes = [...written(["HIL", "Real", "3 · 1000 ft", "Casa"]).placed.values()].map(({ box }) => box);
  expect(boxes).toHaveLength(4);
  for (const [index, one] of boxes.entries()) {
    for (const other of boxes.slice(index + 1)) {
      expect(meets(one, other)).toBe(false);
    }
  }
});

test("all words of the flight are read, however many stand in one place", () => {
  expect(written(Array.from({ length: 10 }, () => "Real")).placed.size).toBe(10);
});

test("a word stays on its side when another comes", () => {
  const sheet = written(["Casa"]);
  const before = [...sheet.placed.values()][0];
  written(["Casa", "Real"], sheet);
  expect([...sheet.placed.values()][0]).toEqual(before);
});

test("no word stands where buttons and sources cover the map", () => {
  const covered = { left: 300, top: 200, right: 500, bottom: 330 };
  const words = new Words();
  words.write("3 · 1000 ft", { x: 400, y: 300 }, 8, "#fff");
  const sheet = new LabelSheet(letters);
  words.paint(context, sheet, 800, 600, 1, [covered]);
  const [placed] = [...sheet.placed.values()];
  if (placed === undefined) throw new Error("the word is not shown");
  expect(meets(placed.box, covered)).toBe(false);
});
