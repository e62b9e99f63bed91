import { expect, test } from "vitest";
import { amended, begun, edited, redone, undone } from "./history";

test("edits are taken back one by one and put in again", () => {
  const third = edited(edited(begun("a"), "b"), "c");
  const back = undone(undone(third));
  expect(back.present).toBe("a");
  expect(redone(redone(back))).toEqual(third);
});

test("at either end nothing more happens", () => {
  const only = begun("a");
  expect(undone(only)).toBe(only);
  expect(redone(only)).toBe(only);
});

test("an edit after an undo gives up what was undone", () => {
  const other = edited(undone(edited(begun("a"), "b")), "c");
  expect(redone(other).present).toBe("c");
  expect(undone(other).present).toBe("a");
});

test("the same value again is no edit", () => {
  const history = edited(begun("a"), "b");
  expect(edited(history, "b")).toBe(history);
});

test("goes back two hundred edits and no further", () => {
  let history = begun(0);
  for (let value = 1; value <= 300; value += 1) {
    history = edited(history, value);
  }
  for (let steps = 0; steps < 300; steps += 1) {
    history = undone(history);
  }
  expect(history.present).toBe(100);
});

test("an edit that is taken further is undone in one step, and gives up what was undone", () => {
  const further = amended(amended(edited(begun("a"), "b"), "c"), "d");
  expect(further.present).toBe("d");
  expect(undone(further).present).toBe("a");
  expect(redone(amended(undone(further), "e")).present).toBe("e");
  expect(amended(further, "d")).toBe(further);
});
