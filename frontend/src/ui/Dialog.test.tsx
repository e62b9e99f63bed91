import { screen } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { expect, test, vi } from "vitest";
import { ConfirmDialog } from "./ConfirmDialog";
import { Dialog } from "./Dialog";
import { renderWithWords } from "./test/testWords";

function draw() {
  const onClose = vi.fn();
  renderWithWords(
    <Dialog
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

function ask() {
  const [onConfirm, onCancel] = [vi.fn(), vi.fn()];
  renderWithWords(
    <ConfirmDialog
      title="Reset"
      text="The board starts anew."
      confirmLabel="Yes"
      cancelLabel="No"
      onConfirm={onConfirm}
      onCancel={onCancel}
    />,
  );
  return { onConfirm, onCancel };
}

test("a question is answered with its one button", async () => {
  const { onConfirm, onCancel } = ask();
  expect(screen.getByRole("alertdialog", { description: "The board starts anew." })).toBeDefined();
  await userEvent.click(screen.getByRole("button", { name: "Yes" }));
  expect(onConfirm).toHaveBeenCalledTimes(1);
  expect(onCancel).not.toHaveBeenCalled();
});

test("and declined with the other, and with Escape", async () => {
  const { onConfirm, onCancel } = ask();
  await userEvent.click(screen.getByRole("button", { name: "No" }));
  await userEvent.keyboard("{Escape}");
  expect(onCancel).toHaveBeenCalledTimes(2);
  expect(onConfirm).not.toHaveBeenCalled();
});
