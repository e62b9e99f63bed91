import { expect, test } from "vitest";
import { DamageRate } from "./damage";

test("only the damage of the last second counts", () => {
  const rate = new DamageRate();
  expect(rate.observe(100, 0)).toBe(0);
  expect(rate.observe(103, 500)).toBe(3);
  expect(rate.observe(105, 1000)).toBe(5);
  expect(rate.observe(105, 1500)).toBe(2);
  expect(rate.observe(105, 2000)).toBe(0);
});

test("a link that was opened again does not give a negative number", () => {
  const rate = new DamageRate();
  rate.observe(100, 0);
  expect(rate.observe(0, 500)).toBe(0);
  expect(rate.observe(2, 1000)).toBe(2);
});
