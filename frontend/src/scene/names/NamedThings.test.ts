import { afterEach, beforeEach, expect, test, vi } from "vitest";
import type { NamedThing } from "../world/things";
import type { World } from "../world/World";
import { NamedThings, type Sight } from "./NamedThings";

/** From 10 km, over this longitude: 0.01 degrees are a kilometre. */
function sight(longitude_deg: number, sight_m = 10_000): Sight {
  return {
    centre: { latitude_deg: 27.93, longitude_deg },
    sight_m,
    zones: [{ level: 2, from_m: 0, to_m: sight_m }],
  };
}

function town(name: string): NamedThing {
  return { key: name, kind: "town", name, size: 90, rank: 90, latitude_deg: 28, longitude_deg: -15 };
}

interface Question {
  readonly of: Sight;
  readonly answer: (things: NamedThing[]) => void;
  readonly fail: () => void;
}

/** A map whose answers come when the test gives them. */
function asking() {
  const questions: Question[] = [];
  const world = {
    ask: (of: Sight) =>
      new Promise<NamedThing[]>((answer, fail) => {
        questions.push({ of, answer, fail: () => fail(new Error("no map")) });
      }),
  };
  const news = vi.fn();
  return { names: new NamedThings(world as unknown as World, news), questions, news };
}

/** Lets what was answered arrive. */
async function arrive(): Promise<void> {
  await vi.advanceTimersByTimeAsync(0);
}

beforeEach(() => void vi.useFakeTimers());
afterEach(() => vi.useRealTimers());

test("the names of what is seen are asked for at once, and told when they are there", async () => {
  const { names, questions, news } = asking();
  names.see(sight(-15));
  expect(questions.map(({ of }) => of)).toEqual([{ kind: "things", ...sight(-15), most: 500 }]);
  expect(names.things).toEqual([]);
  questions[0]?.answer([town("Telde")]);
  await arrive();
  expect(names.things).toEqual([town("Telde")]);
  expect(news).toHaveBeenCalledOnce();
});

test("names are asked for again when the view has moved or come nearer by enough, and not before", async () => {
  const { names, questions } = asking();
  const see = async (what: Sight): Promise<number> => {
    await vi.advanceTimersByTimeAsync(1000);
    names.see(what);
    const count = questions.length;
    questions.at(-1)?.answer([]);
    await arrive();
    return count;
  };
  expect(await see(sight(-15))).toBe(1);
  // Less than a kilometre, and a tenth nearer or farther.
  expect(await see(sight(-15.01))).toBe(1);
  expect(await see(sight(-15, 9000))).toBe(1);
  expect(await see(sight(-15, 11_000))).toBe(1);
  // One and a half.
  expect(await see(sight(-15.015))).toBe(2);
  expect(await see(sight(-15.015, 8500))).toBe(3);
  expect(await see(sight(-15.015, 10_000))).toBe(4);
});

test("while an answer is awaited nothing is asked, and then only for what is seen last", async () => {
  const { names, questions } = asking();
  names.see(sight(-15));
  names.see(sight(-14));
  names.see(sight(-13));
  expect(questions).toHaveLength(1);
  questions[0]?.answer([]);
  await arrive();
  // A map that moves on is not asked with every picture.
  expect(questions).toHaveLength(1);
  await vi.advanceTimersByTimeAsync(249);
  expect(questions).toHaveLength(1);
  await vi.advanceTimersByTimeAsync(10);
  expect(questions.map(({ of }) => of.centre.longitude_deg)).toEqual([-15, -13]);
});

test("the old names stay while new ones are awaited, and after a question that failed", async () => {
  const { names, questions, news } = asking();
  names.see(sight(-15));
  questions[0]?.answer([town("Telde")]);
  await arrive();
  await vi.advanceTimersByTimeAsync(300);
  names.see(sight(-14));
  expect(names.things).toEqual([town("Telde")]);
  questions[1]?.fail();
  await arrive();
  expect(names.things).toEqual([town("Telde")]);
  expect(news).toHaveBeenCalledOnce();
});

test("a question that failed is asked again after five seconds, without the view having moved", async () => {
  const { names, questions, news } = asking();
  names.see(sight(-15));
  questions[0]?.fail();
  await arrive();
  await vi.advanceTimersByTimeAsync(4900);
  expect(questions).toHaveLength(1);
  await vi.advanceTimersByTimeAsync(200);
  expect(questions).toHaveLength(2);
  questions[1]?.answer([town("Telde")]);
  await arrive();
  expect(news).toHaveBeenCalledOnce();
});

test("a map that is no longer there asks nothing more", async () => {
  const { names, questions } = asking();
  names.see(sight(-15));
  names.see(sight(-14));
  questions[0]?.answer([]);
  await arrive();
  names.dispose();
  await vi.advanceTimersByTimeAsync(60_000);
  expect(questions).toHaveLength(1);
});
