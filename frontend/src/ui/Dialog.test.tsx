import { act, screen, within } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { useState } from "react";
import { afterEach, describe, expect, test, vi } from "vitest";
import { Button } from "./Button";
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

test.each([
  [
    "dialog",
    <Dialog
      key="d"
      title="Send"
      onClose={() => undefined}
      actions={
        <Button onPress={() => undefined} disabledReason="no link">
          Write
        </Button>
      }
    />,
  ],
  [
    "dialog",
    <Dialog key="b" title="Send" onClose={() => undefined}>
      <Button onPress={() => undefined} disabledReason="no link">
        Write
      </Button>
    </Dialog>,
  ],
])(
  "a press that does nothing is answered in front, where the page behind cannot be read",
  async (role, dialog) => {
    const user = userEvent.setup();
    const { refused } = renderWithWords(dialog);
    expect(screen.queryByRole("status")).toBeNull();
    await user.click(screen.getByRole("button", { name: "Write" }));
    expect(within(screen.getByRole(role)).getByRole("status").textContent).toBe("no link");
    expect(refused).toEqual(["no link"]);
    await user.click(screen.getByRole("heading"));
    expect(screen.queryByText("no link", { selector: "[role=status]" })).toBeNull();
  },
);

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

describe("before the next animation frame", () => {
  const held: FrameRequestCallback[] = [];

  /** A page so busy that the keys come before the animation frame after the dialog. */
  function holdAnimationFrames(): void {
    held.length = 0;
    vi.stubGlobal("requestAnimationFrame", (run: FrameRequestCallback) => held.push(run));
    vi.stubGlobal("cancelAnimationFrame", () => undefined);
  }

  function show(): void {
    act(() => {
      for (const run of held.splice(0)) {
        run(0);
      }
    });
  }

  afterEach(() => vi.unstubAllGlobals());

  test("Tab and Enter confirm a question: its safe answer has the focus at once", async () => {
    holdAnimationFrames();
    renderWithWords(
      <>
        <button type="button">Manual</button>
        <button type="button">Assisted</button>
      </>,
    );
    screen.getByRole("button", { name: "Manual" }).focus();
    const { onConfirm, onCancel } = ask();
    const user = userEvent.setup({ delay: null });
    // What a browser has run before the next key arrives.
    await act(async () => undefined);
    await user.tab();
    show();
    await user.keyboard("{Enter}");
    expect([onConfirm.mock.calls.length, onCancel.mock.calls.length]).toEqual([1, 0]);
  });

  test("the focus is in a dialog, and returns to where it was when it closes", async () => {
    holdAnimationFrames();
    renderWithWords(<Opener />);
    const opener = screen.getByRole("button", { name: "Open" });
    const user = userEvent.setup({ delay: null });
    opener.focus();
    await user.keyboard("{Enter}");
    expect(document.activeElement).toBe(screen.getByRole("button", { name: "w-close" }));
    await user.keyboard("{Escape}");
    show();
    expect(document.activeElement).toBe(opener);
  });
});

function Opener() {
  const [isOpen, setOpen] = useState(false);
  return (
    <>
      <button type="button" onClick={() => setOpen(true)}>
        Open
      </button>
      {isOpen && <Dialog title="Opened" onClose={() => setOpen(false)} />}
    </>
  );
}
