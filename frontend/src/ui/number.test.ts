import { describe, expect, test } from "vitest";
import { parseNumber, stepped } from "./number";

describe("what is typed", () => {
  test.each([
    ["12.5", 12.5],
    ["12,5", 12.5],
    [" 0,06 ", 0.06],
    ["-3", -3],
    ["\u22123", -3],
    ["+4.", 4],
    [".5", 0.5],
    ["1.234", 1.234],
  ])("%j is %d", (text, value) => {
    expect(parseNumber(text)).toBe(value);
  });

  test.each([
    "",
    " ",
    "abc",
    "1.2.3",
    "1,2,3",
    "1.234,5",
    "1 000",
    "1e3",
    "--2",
    "-",
    ".",
    "NaN",
    "Infinity",
    "0x10",
  ])("%j is no number", (text) => {
    expect(parseNumber(text)).toBeNull();
  });
});

describe("a step", () => {
  test("lands on the step's decimals and not beside them", () => {
    expect(stepped(0.1, 0.1, 1, 0, 99.99)).toBe(0.2);
    expect(stepped(0.2, 0.1, 1, 0, 99.99)).toBe(0.3);
    expect(stepped(0.06, 0.001, -1, 0, 99.99)).toBe(0.059);
    expect(stepped(1e-7, 1e-7, 1, 0, 1)).toBe(2e-7);
  });

  test("keeps finer decimals that the value already has", () => {
    expect(stepped(0.25, 0.1, 1, 0, 99.99)).toBe(0.35);
  });

  test("does not leave the range", () => {
    expect(stepped(99.95, 0.1, 1, 0, 99.99)).toBe(99.99);
    expect(stepped(0.05, 0.1, -1, 0, 99.99)).toBe(0);
  });
});
