import { describe, expect, test } from "vitest";
import { extent, SignalHistory } from "./signalHistory";

/** A history in which signal `a` was 10, 11, 12, ... at seconds 0, 1, 2, ... */
function counted(rows: number, capacity: number): SignalHistory {
  const history = new SignalHistory(["a"], capacity);
  for (let second = 0; second < rows; second += 1) {
    history.append(second, () => 10 + second);
  }
  return history;
}

describe("the window", () => {
  test("holds the rows of the last seconds, told relative to now", () => {
    const { before_s, values } = counted(5, 8).window(4, 2);
    expect(before_s).toEqual([-2, -1, 0]);
    expect(values.get("a")).toEqual([12, 13, 14]);
  });

  test("is right wherever the ring has wrapped", () => {
    for (let rows = 0; rows < 20; rows += 1) {
      const kept = Math.min(rows, 6);
      const { before_s, values } = counted(rows, 6).window(rows - 1, 100);
      expect(values.get("a")).toEqual(Array.from({ length: kept }, (_, index) => 10 + rows - kept + index));
      expect(before_s).toHaveLength(kept);
    }
  });

  test("of a time in which nothing was heard is empty", () => {
    expect(counted(5, 8).window(100, 10).before_s).toEqual([]);
  });

  test("shows no data as null, and a zero as a zero", () => {
    const history = new SignalHistory(["a"], 4);
    history.append(0, () => null);
    history.append(1, () => 0);
    expect(history.window(1, 10).values.get("a")).toEqual([null, 0]);
  });
});

describe("for other signals", () => {
  test("what stays keeps its past, and what is new begins with no data", () => {
    const history = new SignalHistory(["a", "b"], 4);
    history.append(0, (key) => (key === "a" ? 1 : 2));
    const other = history.withKeys(["b", "c"], 4);
    other.append(1, (key) => (key === "b" ? 3 : 4));
    const { values } = other.window(1, 10);
    expect([...values]).toEqual([
      ["b", [2, 3]],
      ["c", [null, 4]],
    ]);
  });

  test("with less room the newest rows are kept", () => {
    expect(counted(5, 8).withKeys(["a"], 2).window(4, 10).values.get("a")).toEqual([13, 14]);
  });
});

test("the extent passes over what is not there, and of nothing there is none", () => {
  expect(extent([null, 3, -2, null])).toEqual({ min: -2, max: 3 });
  expect(extent([null])).toBeNull();
});
