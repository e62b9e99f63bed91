import { expect, test } from "vitest";
import { Words } from "./Words";

interface Written {
  readonly text: string;
  readonly x: number;
  readonly y: number;
}

/** Letters ten pixels high, and eight wide each. */
function paper() {
  const written: Written[] = [];
  const context = {
    measureText: (text: string) => ({ width: 8 * text.length, fontBoundingBoxAscent: 10 }),
    strokeText: () => undefined,
    fillText: (text: string, x: number, y: number) => written.push({ text, x, y }),
  };
  return { words: new Words(context as unknown as CanvasRenderingContext2D), written };
}

test("words stand right above their place", () => {
  const { words, written } = paper();
  words.write("Casa", { x: 100, y: 50 }, 8, "#fff");
  expect(written[0]?.x).toBeGreaterThan(100);
  expect(written[0]?.y).toBeLessThan(50);
});

test("the words of two things in one place do not stand over each other", () => {
  const { words, written } = paper();
  for (const text of ["HIL", "Real", "3 · 1000 ft", "Casa"]) {
    words.write(text, { x: 100, y: 50 }, 8, "#fff");
  }
  const boxes = written.map(({ text, x, y }) => ({ left: x, right: x + 8 * text.length, y }));
  for (const [index, one] of boxes.entries()) {
    for (const other of boxes.slice(index + 1)) {
      const isBeside = one.right <= other.left || other.right <= one.left;
      expect(isBeside || Math.abs(one.y - other.y) >= 12).toBe(true);
    }
  }
});

test("where there is no room they are written all the same", () => {
  const { words, written } = paper();
  for (let index = 0; index < 10; index += 1) {
    words.write("Real", { x: 100, y: 50 }, 8, "#fff");
  }
  expect(written).toHaveLength(10);
});
