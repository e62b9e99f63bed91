import { describe, expect, test } from "vitest";
import { Playout } from "./playout";

function linear(): Playout<number> {
  return new Playout<number>((from, to, share) => from + share * (to - from));
}

/** The values shown at 60 Hz for a value that grows by one a second, sampled at a rate and received 40 ms later. */
function shownAt(
  rate_hz: number,
  jitter: (index: number) => number = () => 0,
): { now_s: number; shown: number }[] {
  const playout = linear();
  const shown: { now_s: number; shown: number }[] = [];
  let next = 0;
  for (let picture = 0; picture < 600; picture += 1) {
    const now_s = 100 + picture / 60;
    for (; 100 + next / rate_hz + 0.04 + jitter(next) <= now_s; next += 1) {
      playout.push(100 + next / rate_hz, next / rate_hz, now_s);
    }
    const value = playout.at(now_s)?.value;
    if (value !== undefined && picture > 240) {
      shown.push({ now_s, shown: value });
    }
  }
  return shown;
}

describe.each([50, 10, 5, 1])("a stream of %i Hz", (rate_hz) => {
  test("is shown moving evenly from picture to picture", () => {
    const steps = shownAt(rate_hz).map(
      ({ shown }, index, all) => shown - (all[index - 1]?.shown ?? shown - 1 / 60),
    );
    expect(Math.min(...steps)).toBeGreaterThan(0.4 / 60);
    expect(Math.max(...steps)).toBeLessThan(1.6 / 60);
  });

  test("is shown no later than one sample and its way", () => {
    for (const { now_s, shown } of shownAt(rate_hz)) {
      const behind_s = now_s - 100 - shown;
      expect(behind_s).toBeLessThan(1 / rate_hz + 0.04 + 2 / 60);
      expect(behind_s).toBeGreaterThan(0.03);
    }
  });
});

test("a late sample holds the newest for a moment and never goes back", () => {
  const shown = shownAt(10, (index) => (index % 7 === 0 ? 0.05 : 0)).map((each) => each.shown);
  expect(shown.every((value, index) => index === 0 || value >= (shown[index - 1] ?? 0) - 0.011)).toBe(true);
});

test("before the first sample there is nothing, and one alone is shown as it is", () => {
  const playout = linear();
  expect(playout.at(5)).toBeNull();
  playout.push(4, 7, 4.1);
  expect(playout.at(5)).toEqual({ t_s: 4, value: 7 });
});

test("nothing is made up beyond the newest sample", () => {
  const playout = linear();
  playout.push(1, 1, 1);
  playout.push(2, 2, 2);
  expect(playout.at(60)?.value).toBe(2);
});

test("after a long gap the next sample is shown at once, without a way between", () => {
  const playout = linear();
  playout.push(1, 1, 1);
  playout.push(2, 2, 2);
  playout.push(60, 500, 60);
  expect(playout.at(60)?.value).toBe(500);
});

test("a sample that comes twice is one", () => {
  const playout = linear();
  for (const now_s of [1, 1.1, 1.2]) {
    playout.push(1, 1, now_s);
  }
  playout.push(2, 3, 2);
  expect(playout.at(2.5)?.value).toBeCloseTo(2);
});

test("a clock that was set back begins anew", () => {
  const playout = linear();
  playout.push(1000, 1, 1000);
  playout.push(10, 5, 10);
  expect(playout.at(10)?.value).toBe(5);
});
