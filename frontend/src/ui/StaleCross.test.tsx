import { render, screen } from "@testing-library/react";
import { expect, test } from "vitest";
import { StaleCross } from "./StaleCross";

test("the cross says in words that there is nothing live, and is gone when there is", () => {
  const { container, rerender } = render(<StaleCross text="NO DATA" />);
  expect(screen.getByText("NO DATA")).toBeDefined();
  expect(container.querySelector("path")).not.toBeNull();
  rerender(<StaleCross text="NO DATA" shown={false} />);
  expect(container.innerHTML).toBe("");
});
