import { render } from "@testing-library/react";
import { expect, test } from "vitest";
import { StateMark } from "./StateMark";
import type { CommandState } from "./words";

test("a resting command has the place of a mark and none in it, every other state one of its own shape", () => {
  const states: CommandState[] = ["pending", "confirmed", "rejected", "timed_out", "sent"];
  const shapes = states.map(
    (state) => render(<StateMark state={state} />).container.querySelector("svg")?.innerHTML,
  );
  expect(new Set(shapes).size).toBe(states.length);
  const resting = render(<StateMark state="idle" />).container;
  expect(resting.querySelector(".ui-mark")?.innerHTML).toBe("");
});
