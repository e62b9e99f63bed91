import { screen } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { expect, test, vi } from "vitest";
import { Dialog } from "./Dialog";
import { renderWithWords } from "./test/words";

function draw(open = true) {
  const onClose = vi.fn();
  renderWithWords(
    <Dialog
      open={open}
      onClose={onClose}
      title="Reset all"
      description="17 lines"
      actions={<button type="button">Write</button>}
    >
      <p>the lines</p>
    </Dialog>,
  );
  return onClose;
}

test("is a dialog with its title as name and what it is about as description", () => {
  draw();
  expect(screen.getByRole("dialog", { name: "Reset all", description: "17 lines" }).textContent).toContain(
    "the lines",
  );
  expect(screen.getByRole("button", { name: "Write" })).toBeDefined();
});

test("Escape and the cross ask to close it", async () => {
  const onClose = draw();
  await userEvent.keyboard("{Escape}");
  expect(onClose).toHaveBeenCalledTimes(1);
  await userEvent.click(screen.getByRole("button", { name: "w-close" }));
  expect(onClose).toHaveBeenCalledTimes(2);
});

test("closed, it is not there", () => {
  draw(false);
  expect(screen.queryByRole("dialog")).toBeNull();
});
