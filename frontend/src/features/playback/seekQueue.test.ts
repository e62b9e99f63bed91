import { beforeEach, expect, test } from "vitest";
import { ManualTimers } from "../../test/wire";
import { SeekQueue } from "./seekQueue";

let timers: ManualTimers;
let sent: number[];
let queue: SeekQueue;

beforeEach(() => {
  timers = new ManualTimers();
  sent = [];
  queue = new SeekQueue((at_s) => sent.push(at_s), timers);
});

test("one is under way at a time, and of those that wait the newest wins", () => {
  for (const at_s of [1, 2, 3]) {
    queue.ask(at_s);
  }
  expect(sent).toEqual([1]);
  timers.pass(60);
  queue.answered();
  expect(sent).toEqual([1, 3]);
  queue.answered();
  expect(queue.isBusy).toBe(false);
});

test("a drag that is answered at once sends at most twenty a second", () => {
  for (let at_ms = 0; at_ms < 990; at_ms += 10) {
    queue.ask(at_ms);
    queue.answered();
    timers.pass(10);
  }
  expect(sent.length).toBeGreaterThan(15);
  expect(sent.length).toBeLessThanOrEqual(20);
});

test("where the hand lets go is asked for at once, or as soon as the one under way is answered", () => {
  queue.ask(1);
  queue.answered();
  queue.ask(2);
  expect(sent).toEqual([1]);
  queue.hurry();
  expect(sent).toEqual([1, 2]);
  queue.ask(3);
  queue.hurry();
  expect(sent).toEqual([1, 2]);
  queue.answered();
  expect(sent).toEqual([1, 2, 3]);
  queue.answered();
  queue.hurry();
  queue.ask(4);
  expect(sent, "the next drag has its pace again").toEqual([1, 2, 3]);
});

test("an answer that never comes does not hold up the next one for ever", () => {
  queue.ask(1);
  queue.ask(2);
  timers.pass(1000);
  expect(sent).toEqual([1, 2]);
});

test("what waits is forgotten with the flight", () => {
  queue.ask(1);
  queue.ask(2);
  queue.clear();
  timers.pass(5000);
  expect(sent).toEqual([1]);
});
