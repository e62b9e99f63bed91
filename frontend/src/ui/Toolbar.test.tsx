import { render, screen, within } from "@testing-library/react";
import { expect, test } from "vitest";
import { Toolbar, ToolbarGroup } from "./Toolbar";

test("a bar and its groups are named", () => {
  render(
    <Toolbar label="Autopilot bar">
      <ToolbarGroup label="Autotrim">
        <button type="button">On</button>
      </ToolbarGroup>
    </Toolbar>,
  );
  const bar = screen.getByRole("group", { name: "Autopilot bar" });
  const group = within(bar).getByRole("group", { name: "Autotrim" });
  expect(within(group).getByRole("button", { name: "On" })).toBeDefined();
});
