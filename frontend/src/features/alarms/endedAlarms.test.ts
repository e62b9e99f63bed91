import { expect, test } from "vitest";
import { type EndedAlarm, endedBetween, withEnded } from "./endedAlarms";

const raised = { level: "warning", since_s: 10, text: "said", params: {}, acknowledged: false } as const;

function ended(id: string, until_s = 20): EndedAlarm {
  return { id, level: "warning", text: "said", until_s };
}

test("an alarm has ended when it is gone and nobody had acknowledged it", () => {
  const before = [
    { ...raised, id: "gone" },
    { ...raised, id: "known", acknowledged: true },
    { ...raised, id: "stays" },
  ];
  expect(endedBetween(before, [{ ...raised, id: "stays" }], 20)).toEqual([ended("gone")]);
});

test("the newest stands first, one for each alarm", () => {
  const kept = [ended("b"), ended("a")];
  expect(withEnded(kept, [ended("a", 30)], [])).toEqual([ended("a", 30), ended("b")]);
});

test("what is raised again leaves, and where nothing changes the list is the same one", () => {
  const kept = [ended("b"), ended("a")];
  expect(withEnded(kept, [], ["a"])).toEqual([ended("b")]);
  expect(withEnded(kept, [], ["c"])).toBe(kept);
});

test("a page that stays open for weeks keeps the newest alone", () => {
  const news = Array.from({ length: 30 }, (_, index) => ended(`alarm ${index}`));
  expect(withEnded([], news, [])).toEqual(news.slice(0, 20));
});
