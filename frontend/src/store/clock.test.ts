import { expect, test } from "vitest";
import { ServerClock } from "./clock";

test("nothing heard has no time", () => {
  expect(new ServerClock().now_s(5)).toBeNull();
});

test("a message that was held up does not turn the clock back", () => {
  const clock = new ServerClock();
  clock.observe(1000, 10);
  clock.observe(1001, 18); // made a second later, seven seconds on the way
  expect(clock.now_s(18)).toBeCloseTo(1008, 1);
});

test("a faster message corrects the estimate at once", () => {
  const clock = new ServerClock();
  clock.observe(1000, 10.3); // 0.3 s on the way
  clock.observe(1001, 11);
  expect(clock.now_s(11)).toBe(1001);
});

test("slow drift of the two clocks is followed", () => {
  const clock = new ServerClock();
  const drift = 0.0002; // the gateway's clock loses 0.2 ms each second
  for (let local_s = 0; local_s <= 3600; local_s += 1) {
    clock.observe(1000 + local_s * (1 - drift), local_s);
  }
  expect(clock.now_s(3600)).toBeCloseTo(1000 + 3600 * (1 - drift), 3);
});

test("after a reset only the new gateway counts", () => {
  const clock = new ServerClock();
  clock.observe(5000, 10);
  clock.reset();
  clock.observe(1000, 11);
  expect(clock.now_s(11)).toBe(1000);
});

test("an old estimate gives way by half a millisecond for each second since the last message", () => {
  const clock = new ServerClock();
  clock.observe(1000, 10);
  clock.observe(1000, 110); // a hundred seconds on the way
  clock.observe(1000, 310);
  expect(clock.now_s(310)).toBeCloseTo(1300 - 300 * 0.0005, 9);
});

test("a gateway whose clock is behind the page's, and the moment before zero, are times like any other", () => {
  const clock = new ServerClock();
  clock.observe(2, 10);
  expect(clock.now_s(5)).toBe(-3);
  clock.observe(4, 9); // a steady clock never goes back; nothing gives way if it did
  expect(clock.now_s(9)).toBe(4);
});
