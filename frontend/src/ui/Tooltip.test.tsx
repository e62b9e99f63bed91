import { render, screen } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { expect, test } from "vitest";
import { Tooltip } from "./Tooltip";

test("the text comes with the keyboard's focus and goes with Escape", async () => {
  render(
    <Tooltip text="the reason">
      <button type="button">Open</button>
    </Tooltip>,
  );
  expect(screen.queryByText("the reason")).toBeNull();
  await userEvent.tab();
  expect(await screen.findByText("the reason")).toBeDefined();
  await userEvent.keyboard("{Escape}");
  expect(screen.queryByText("the reason")).toBeNull();
});

test("with nothing to say nothing opens", async () => {
  const { container } = render(
    <Tooltip text="">
      <button type="button">Open</button>
    </Tooltip>,
  );
  await userEvent.tab();
  expect(document.activeElement?.textContent).toBe("Open");
  expect(document.body.querySelector(".ui-tooltip")).toBeNull();
  expect(container.textContent).toBe("Open");
});
