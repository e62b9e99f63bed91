import { describe, expect, test } from "vitest";
import { groundSpeed_kt, legTimes_s, windOf } from "./wind";

function random(seed: number): () => number {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1_664_525) + 1_013_904_223) >>> 0;
    return state / 2 ** 32;
  };
}

describe("the ground speed", () => {
  test.each([
    [0, 50],
    [180, 70],
  ])("with 10 kt from %d° on a course north at 60 kt is %d", (from_deg, ground_kt) => {
    expect(groundSpeed_kt(0, 60, { from_deg, speed_kt: 10 })).toBeCloseTo(ground_kt, 6);
  });

  test("is none against a wind as strong as the aircraft is fast, from ahead or from the side", () => {
    expect(groundSpeed_kt(0, 40, { from_deg: 0, speed_kt: 40 })).toBeNull();
    expect(groundSpeed_kt(0, 40, { from_deg: 90, speed_kt: 45 })).toBeNull();
  });

  test("along a course, and the wind, are one triangle: each gives the other", () => {
    const next = random(5);
    for (let tried = 0; tried < 500; tried += 1) {
      const [course_deg, airspeed_kt] = [next() * 360, 40 + next() * 40];
      const wind = { from_deg: next() * 360, speed_kt: 1 + next() * 30 };
      const ground_kt = groundSpeed_kt(course_deg, airspeed_kt, wind) ?? Number.NaN;
      const drift = (wind.speed_kt / airspeed_kt) * Math.sin(((wind.from_deg - course_deg) * Math.PI) / 180);
      const heading_deg = course_deg + (Math.asin(drift) * 180) / Math.PI;
      const found = windOf(heading_deg, airspeed_kt, course_deg, ground_kt);
      expect(found.speed_kt).toBeCloseTo(wind.speed_kt, 6);
      expect(Math.cos(((found.from_deg - wind.from_deg) * Math.PI) / 180)).toBeCloseTo(1, 9);
    }
  });
});

test("a leg of a nautical mile at 60 kt takes a minute in still air, and none can be said in a gale", () => {
  const from = { latitude_deg: 28, longitude_deg: -15, altitude_ft: 500, speed_kt: 60 };
  const plan = [from, { ...from, latitude_deg: 28 + 1852 / 111_195.08 }];
  expect(legTimes_s(plan, { from_deg: 0, speed_kt: 0 })[0]).toBeCloseTo(60, 1);
  expect(legTimes_s(plan, { from_deg: 0, speed_kt: 80 })).toEqual([null]);
});
