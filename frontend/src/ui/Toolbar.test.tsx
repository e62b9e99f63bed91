import { render, screen, within } from "@testing-library/react";
import { expect, test } from "vitest";
import { Toolbar } from "./Toolbar";

test("a bar is a named group", () => {
  render(
    <Toolbar label="Autopilot bar">
      <button type="button">On</button>
    </Toolbar>,
  );
  const bar = screen.getByRole("group", { name: "Autopilot bar" });
  expect(within(bar).getByRole("button", { name: "On" })).toBeDefined();
});
