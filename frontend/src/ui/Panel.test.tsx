import { render, screen, within } from "@testing-library/react";
import { expect, test } from "vitest";
import { Panel } from "./Panel";

test("a panel is a region named by its heading", () => {
  render(
    <Panel title="Gyros" level={3} badge={<i>badge</i>} actions={<button type="button">Read</button>}>
      content
    </Panel>,
  );
  const panel = screen.getByRole("region", { name: "Gyros" });
  expect(within(panel).getByRole("heading", { level: 3, name: "Gyros" })).toBeDefined();
  expect(within(panel).getByText("content")).toBeDefined();
  expect(within(panel).getByText("badge")).toBeDefined();
  expect(within(panel).getByRole("button", { name: "Read" })).toBeDefined();
});
