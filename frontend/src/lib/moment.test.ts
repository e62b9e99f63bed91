import { expect, test } from "vitest";
import { formatClock, formatMoment } from "./moment";

const at_s = new Date(2026, 10, 5, 7, 4, 9).getTime() / 1000;

test("a moment of today is its time, 24 hours, two digits each", () => {
  expect(formatClock(at_s)).toBe("07:04:09");
  expect(formatMoment(at_s, at_s + 3600)).toBe("07:04:09");
});

test("a moment of another day has its day", () => {
  expect(formatMoment(at_s, at_s + 86_400)).toBe("2026-11-05 07:04:09");
});
