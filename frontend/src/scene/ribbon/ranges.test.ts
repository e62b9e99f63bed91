import { expect, test } from "vitest";
import { rangesOf } from "./ranges";

/** Ten blocks of a hundred points. */
const STARTS = Array.from({ length: 10 }, (_, block) => 100 * block);
const COUNT = 1000;

function seen(...blocks: number[]) {
  return rangesOf(STARTS, COUNT, (block) => blocks.includes(block));
}

test("a line of which nothing is seen is not drawn, and one that is all seen is one stretch", () => {
  expect(seen()).toEqual([]);
  expect(rangesOf(STARTS, COUNT, () => true)).toEqual([{ begin: 0, end: COUNT - 1 }]);
});

test("a block that is seen is drawn with the stretch that leads to it and the one that leads on", () => {
  expect(seen(3)).toEqual([{ begin: 299, end: 400 }]);
  expect(seen(0, 9)).toEqual([
    { begin: 0, end: 100 },
    { begin: 899, end: 999 },
  ]);
});

test("a few points that are not seen are drawn along", () => {
  expect(rangesOf([0, 500, 530], COUNT, (block) => block !== 1)).toEqual([{ begin: 0, end: COUNT - 1 }]);
});

test("blocks without a point of their own draw nothing, and hide nothing of the others", () => {
  expect(rangesOf([0, 0, 0], 1, () => true)).toEqual([]);
  expect(rangesOf([0, 200, 200, 200], 400, (block) => block === 3)).toEqual([{ begin: 199, end: 399 }]);
});

test("however many parts are seen, the drawings are few and all of them is drawn", () => {
  const starts = Array.from({ length: 200 }, (_, block) => 100 * block);
  const found = rangesOf(starts, 20_000, (block) => block % 2 === 0);
  expect(found.length).toBeLessThanOrEqual(12);
  for (let block = 0; block < 200; block += 2) {
    const whole = found.some(({ begin, end }) => begin <= 100 * block && end >= 100 * block + 99);
    expect(whole, `block ${block}`).toBe(true);
  }
});
