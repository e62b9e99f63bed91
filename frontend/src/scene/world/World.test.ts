import { expect, test, vi } from "vitest";
import type { NumberedAnswer, NumberedQuestion } from "./messages";
import { World } from "./World";

const NEAR = { kind: "near", place: { latitude_deg: 28, longitude_deg: -15 }, most: 3 } as const;

/** A worker that the test answers for. */
class SomeWorker {
  onmessage: ((event: { data: NumberedAnswer }) => void) | null = null;
  onerror: ((event: { message: string; preventDefault: () => void }) => void) | null = null;
  readonly asked: NumberedQuestion[] = [];

  postMessage(question: NumberedQuestion): void {
    this.asked.push(question);
  }

  /** Answers the question that was asked as the nth. */
  answer(nth: number, answer: Omit<Extract<NumberedAnswer, { answer: unknown }>, "number">): void {
    this.onmessage?.({ data: { number: this.asked[nth]?.number ?? -1, ...answer } });
  }

  refuse(nth: number, fault: string): void {
    this.onmessage?.({ data: { number: this.asked[nth]?.number ?? -1, fault } });
  }
}

function aWorld() {
  const workers: SomeWorker[] = [];
  const world = new World(() => {
    const worker = new SomeWorker();
    workers.push(worker);
    return worker as unknown as Worker;
  });
  return { world, workers };
}

test("the map's worker is started with the first question, and only once", () => {
  const { world, workers } = aWorld();
  expect(workers).toHaveLength(0);
  void world.ask<"near">(NEAR);
  void world.ask<"near">(NEAR);
  expect(workers).toHaveLength(1);
  expect(workers[0]?.asked).toHaveLength(2);
});

test("each question gets its own answer, in whatever order they come", async () => {
  const { world, workers } = aWorld();
  const first = world.ask<"near">(NEAR);
  const second = world.ask<"things">({
    kind: "things",
    centre: NEAR.place,
    zones: [],
    sight_m: 1,
    most: 1,
  });
  const [near, things]: [[], []] = [[], []];
  workers[0]?.answer(1, { answer: things });
  workers[0]?.answer(0, { answer: near });
  expect(await first).toBe(near);
  expect(await second).toBe(things);
});

test("a question that cannot be answered is refused with the reason, and the others go on", async () => {
  const { world, workers } = aWorld();
  const bad = world.ask<"near">(NEAR);
  const good = world.ask<"near">(NEAR);
  workers[0]?.refuse(0, "cut off");
  workers[0]?.answer(1, { answer: [] });
  await expect(bad).rejects.toThrow("cut off");
  expect(await good).toEqual([]);
});

test("an answer to nothing that was asked is passed over", async () => {
  const { world, workers } = aWorld();
  const asked = world.ask<"near">(NEAR);
  workers[0]?.refuse(7, "whose?");
  workers[0]?.answer(0, { answer: [] });
  workers[0]?.answer(0, { answer: [] });
  expect(await asked).toEqual([]);
});

test("a worker that breaks refuses all that waits, and the next question starts another", async () => {
  const { world, workers } = aWorld();
  const waiting = [world.ask<"near">(NEAR), world.ask<"near">(NEAR)];
  const preventDefault = vi.fn();
  workers[0]?.onerror?.({ message: "out of memory", preventDefault });
  for (const asked of waiting) {
    await expect(asked).rejects.toThrow("out of memory");
  }
  expect(preventDefault).toHaveBeenCalledOnce();
  const again = world.ask<"near">(NEAR);
  expect(workers).toHaveLength(2);
  workers[1]?.answer(0, { answer: [] });
  expect(await again).toEqual([]);
});

test("a browser that starts no worker refuses the question, and is asked again with the next one", async () => {
  const start = vi.fn(() => {
    throw new Error("no workers here");
  });
  const world = new World(start);
  await expect(world.ask<"near">(NEAR)).rejects.toThrow("no workers here");
  await expect(world.ask<"near">(NEAR)).rejects.toThrow("no workers here");
  expect(start).toHaveBeenCalledTimes(2);
});
