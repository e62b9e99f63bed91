import { expect, test } from "vitest";
import { StreamRates } from "./rates";

test("the rate is what arrived in the last two seconds, over those", () => {
  const rates = new StreamRates();
  expect(rates.observe(100, { ahrs: 1000 })).toEqual({});
  expect(rates.observe(100.5, { ahrs: 1005 })).toEqual({ ahrs: 10 });
  rates.observe(102.5, { ahrs: 1025 });
  expect(rates.observe(104.5, { ahrs: 1125 })).toEqual({ ahrs: 50 });
});

test("a stream that stopped comes down to zero", () => {
  const rates = new StreamRates();
  rates.observe(100, { ahrs: 10 });
  rates.observe(102, { ahrs: 10 });
  expect(rates.observe(104, { ahrs: 10 })).toEqual({ ahrs: 0 });
});

test("a gateway that started again begins anew", () => {
  const rates = new StreamRates();
  rates.observe(100, { ahrs: 5000 });
  expect(rates.observe(50, { ahrs: 3 })).toEqual({});
  expect(rates.observe(51, { ahrs: 13 })).toEqual({ ahrs: 10 });
});
