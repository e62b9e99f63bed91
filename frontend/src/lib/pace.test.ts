import { expect, test } from "vitest";
import { Pace } from "./pace";

test("a pace answers yes once in its period, at once at first, and at once after a reset", () => {
  const pace = new Pace(100);
  expect([0, 50, 99, 100, 150, 201].map((now_ms) => pace.due(now_ms))).toEqual([
    true,
    false,
    false,
    true,
    false,
    true,
  ]);
  pace.reset();
  expect(pace.due(202)).toBe(true);
});

test("paces that began at different times are due in the same frames", () => {
  const [early, late, slow] = [new Pace(100), new Pace(100), new Pace(500)];
  const dueAt = (pace: Pace, from_ms: number): number[] =>
    Array.from({ length: 60 }, (_, frame) => frame * 16.7).filter(
      (now_ms) => now_ms >= from_ms && pace.due(now_ms),
    );
  const shared = dueAt(early, 300).slice(1);
  expect(dueAt(late, 345).slice(1)).toEqual(shared);
  expect(shared).toEqual(expect.arrayContaining(dueAt(slow, 310).slice(1)));
});
