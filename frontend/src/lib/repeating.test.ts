import { expect, test } from "vitest";
import { ManualTimers } from "../test/wire";
import { Polling, Repeating } from "./repeating";

const reported: unknown[] = [];

function timersThatReport() {
  reported.length = 0;
  const manual = new ManualTimers();
  return { manual, timers: { ...manual, report: (error: unknown) => reported.push(error) } };
}

/** Let promises end. */
async function settle(): Promise<void> {
  await new Promise((done) => setImmediate(done));
}

test("a run of turns that throw is reported once and counted, and the next turn comes", () => {
  const { manual, timers } = timersThatReport();
  const fault = new Error("the second and third turn");
  let turns = 0;
  const repeating = new Repeating(
    timers,
    () => {
      turns += 1;
      if (turns === 2 || turns === 3) {
        throw fault;
      }
      return 10;
    },
    50,
  );
  repeating.run();
  manual.pass(10);
  expect([turns, reported]).toEqual([2, [fault]]);
  manual.pass(50);
  manual.pass(50);
  expect([turns, reported, repeating.failures]).toEqual([4, [fault], 2]);
  manual.pass(10);
  expect(turns).toBe(5);
});

test("a turn that cancels its chain ends it, and one that was run meanwhile takes its place", async () => {
  const { manual, timers } = timersThatReport();
  let turns = 0;
  const ending: Repeating = new Repeating(
    timers,
    () => {
      turns += 1;
      ending.cancel();
      return 10;
    },
    10,
  );
  ending.run();
  manual.pass(100);
  expect([turns, ending.isArmed]).toEqual([1, false]);

  const answers: Array<(in_ms: number) => void> = [];
  const asking = new Repeating(timers, () => new Promise<number>((done) => answers.push(done)), 10);
  asking.run();
  asking.run();
  answers[0]?.(5);
  await settle();
  expect(asking.isArmed).toBe(false);
  answers[1]?.(5);
  await settle();
  expect(asking.isArmed).toBe(true);
});

test("what is watched is read at once and again, also after a read that failed, until nobody watches", async () => {
  const { manual, timers } = timersThatReport();
  let reads = 0;
  const polling = new Polling(timers, 1000, async () => {
    reads += 1;
    if (reads === 1) {
      throw new Error("the first read");
    }
  });
  const end = polling.watch();
  const endOther = polling.watch();
  await settle();
  manual.pass(1000);
  await settle();
  expect([reads, reported.length]).toEqual([2, 1]);
  end();
  end();
  manual.pass(1000);
  await settle();
  expect(reads).toBe(3);
  endOther();
  manual.pass(5000);
  expect([reads, polling.isWatched]).toEqual([3, false]);
});

test("what need not be read again waits until somebody asks for it", async () => {
  const { manual, timers } = timersThatReport();
  let reads = 0;
  const polling = new Polling(timers, 1000, async () => {
    reads += 1;
    return false;
  });
  polling.watch();
  await settle();
  manual.pass(5000);
  expect(reads).toBe(1);
  polling.read();
  expect(reads).toBe(2);
});
