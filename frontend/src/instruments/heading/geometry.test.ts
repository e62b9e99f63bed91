import { describe, expect, test } from "vitest";
import {
  attributeBearing,
  bugTransform,
  cardNumerals,
  cardTransform,
  TICKS_FIVE,
  TICKS_TEN,
} from "./geometry";

const CARDINALS = { north: "N", east: "E", south: "S", west: "O" };

describe("the compass card", () => {
  test("stands with north up at a heading of zero", () => {
    expect(cardTransform(0)).toBe("rotate(0)");
    expect(cardTransform(-0)).toBe("rotate(0)");
  });

  test("turns left as the aircraft turns right, so that the heading's mark comes under the lubber line", () => {
    // East is drawn at three o'clock; a quarter turn to the left, 270, brings it to the top.
    expect(cardTransform(90)).toBe("rotate(270)");
    expect(cardTransform(10)).toBe("rotate(350)");
  });

  test("knows -180..180 and 0..360 as the same headings", () => {
    expect(cardTransform(-90)).toBe(cardTransform(270));
    expect(cardTransform(-180)).toBe(cardTransform(180));
    expect(cardTransform(360)).toBe(cardTransform(0));
  });

  test("does not jump at the wrap", () => {
    expect(cardTransform(359.9996)).toBe("rotate(0)");
    expect(cardTransform(359.9)).toBe("rotate(0.1)");
    expect(cardTransform(0.1)).toBe("rotate(359.9)");
  });

  test("carries letters at the cardinal points and tens of degrees between them", () => {
    expect(cardNumerals(CARDINALS).map(({ text }) => text)).toEqual([
      ..."N 3 6 E 12 15 S 21 24 O 30 33".split(" "),
    ]);
  });

  test("has a tick each five degrees, none of them twice", () => {
    expect(TICKS_TEN.match(/M/g)).toHaveLength(36);
    expect(TICKS_FIVE.match(/M/g)).toHaveLength(36);
  });
});

describe("the bug", () => {
  test("stands under the lubber line when the heading is the bearing", () => {
    expect(bugTransform(145, 145)).toBe("rotate(0)");
    expect(bugTransform(359.9996, 359.9996)).toBe("rotate(0)");
  });

  test("stands to the right of it while the plan wants a turn to the right", () => {
    expect(bugTransform(100, 145)).toBe("rotate(45)");
    expect(bugTransform(350, 10)).toBe("rotate(20)");
  });

  test("stands to the left of it while the plan wants a turn to the left", () => {
    expect(bugTransform(10, 350)).toBe("rotate(340)");
  });

  test("keeps its place on the card", () => {
    const place = (transform: string) => Number(/[\d.]+/.exec(transform)?.[0]);
    const onCard = (place(bugTransform(77, 145)) - place(cardTransform(77)) + 360) % 360;
    expect(onCard).toBeCloseTo(145, 6);
  });
});

test("a heading is written from 0.0 to 359.9 and never as 360.0", () => {
  expect(attributeBearing(359.9996)).toBe("0.0");
  expect(attributeBearing(359.94)).toBe("359.9");
  expect(attributeBearing(-0.01)).toBe("0.0");
  expect(attributeBearing(-90)).toBe("270.0");
});
