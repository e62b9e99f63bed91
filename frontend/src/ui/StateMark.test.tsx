import { render } from "@testing-library/react";
import { expect, test } from "vitest";
import { StateMark } from "./StateMark";
import type { CommandState } from "./words";

test("a resting command has no mark, every other state one of its own shape", () => {
  const states: CommandState[] = ["pending", "confirmed", "rejected", "timed_out", "sent"];
  const shapes = states.map(
    (state) => render(<StateMark state={state} />).container.querySelector("svg")?.innerHTML,
  );
  expect(new Set(shapes).size).toBe(states.length);
  expect(render(<StateMark state="idle" />).container.innerHTML).toBe("");
});
