import { describe, expect, test } from "vitest";
import { attributeBearing, bugTurn_deg, cardNumerals, cardTurn_deg, TICKS_FIVE, TICKS_TEN } from "./geometry";

const CARDINALS = { north: "N", east: "E", south: "S", west: "O" };

describe("the compass card", () => {
  test("stands with north up at a heading of zero", () => {
    expect(cardTurn_deg(0)).toBe(0);
    expect(cardTurn_deg(-0)).toBe(0);
  });

  test("turns left as the aircraft turns right, so that the heading's mark comes under the lubber line", () => {
    // East is drawn at three o'clock; a quarter turn to the left, 270, brings it to the top.
    expect(cardTurn_deg(90)).toBe(270);
    expect(cardTurn_deg(10)).toBe(350);
  });

  test("knows -180..180 and 0..360 as the same headings", () => {
    expect(cardTurn_deg(-90)).toBe(cardTurn_deg(270));
    expect(cardTurn_deg(-180)).toBe(cardTurn_deg(180));
    expect(cardTurn_deg(360)).toBe(cardTurn_deg(0));
  });

  test("does not jump at the wrap", () => {
    expect(cardTurn_deg(359.9996)).toBe(0);
    expect(cardTurn_deg(359.9)).toBe(0.1);
    expect(cardTurn_deg(0.1)).toBe(359.9);
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
    expect(bugTurn_deg(145, 145)).toBe(0);
    expect(bugTurn_deg(359.9996, 359.9996)).toBe(0);
  });

  test("stands to the right of it while the plan wants a turn to the right", () => {
    expect(bugTurn_deg(100, 145)).toBe(45);
    expect(bugTurn_deg(350, 10)).toBe(20);
  });

  test("stands to the left of it while the plan wants a turn to the left", () => {
    expect(bugTurn_deg(10, 350)).toBe(340);
  });

  test("keeps its place on the card", () => {
    const onCard = (bugTurn_deg(77, 145) - cardTurn_deg(77) + 360) % 360;
    expect(onCard).toBeCloseTo(145, 6);
  });
});

test("a heading is written from 0.0 to 359.9 and never as 360.0", () => {
  expect(attributeBearing(359.9996)).toBe("0.0");
  expect(attributeBearing(359.94)).toBe("359.9");
  expect(attributeBearing(-0.01)).toBe("0.0");
  expect(attributeBearing(-90)).toBe("270.0");
});
