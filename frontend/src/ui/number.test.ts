import { describe, expect, test } from "vitest";
import { parseNumber, stepped, twoReadings } from "./number";

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

describe("one mark and three digits behind it", () => {
  test.each([
    ["1.000", 0, 60_000, { thousand: "1000", one: "1" }],
    ["1,000", 0, 60_000, { thousand: "1000", one: "1" }],
    ["\u221212,500", -60_000, 60_000, { thousand: "-12500", one: "-12.5" }],
  ])("%j from %d to %d may be a thousand or one", (text, minimum, maximum, readings) => {
    expect(twoReadings(text, minimum, maximum)).toEqual(readings);
  });

  test.each([
    ["27.935", -90, 90],
    ["1.250", 0, 99.99],
    ["0.125", 0, 60_000],
    ["1234.567", 0, 60_000],
    ["1.0", 0, 60_000],
    ["1000", 0, 60_000],
  ])("%j from %d to %d has one reading", (text, minimum, maximum) => {
    expect(twoReadings(text, minimum, maximum)).toBeNull();
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
