import { expect, test } from "vitest";
import { GuardedCalls } from "./guardedCalls";

test("a listener that throws is reported once, and all have every turn", () => {
  const [heard, reported]: [string[], unknown[]] = [[], []];
  const calls = new GuardedCalls((error) => reported.push(error));
  const fault = new Error("at the first value");
  const listeners = [
    (value: number) => {
      if (value < 3) {
        throw fault;
      }
      heard.push(`first ${value}`);
    },
    (value: number) => heard.push(`second ${value}`),
  ];
  for (const value of [1, 2, 3]) {
    calls.each(listeners, (hear) => hear(value));
  }
  expect(heard).toEqual(["second 1", "second 2", "first 3", "second 3"]);
  expect(reported).toEqual([fault]);
});
