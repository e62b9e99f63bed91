import { screen } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { expect, test, vi } from "vitest";
import { Button } from "./Button";
import { renderWithWords } from "./test/testWords";
import type { CommandState } from "./words";

test("a press by pointer or keyboard is one press", async () => {
  const onPress = vi.fn();
  renderWithWords(<Button onPress={onPress}>Open</Button>);
  const button = screen.getByRole("button", { name: "Open" });
  await userEvent.click(button);
  await userEvent.keyboard("{Enter}");
  await userEvent.keyboard(" ");
  expect(onPress).toHaveBeenCalledTimes(3);
});

test("a disabled button can be reached, tells why, and cannot be pressed", async () => {
  const onPress = vi.fn();
  renderWithWords(
    <Button onPress={onPress} disabledReason="no board link">
      Open
    </Button>,
  );
  const button = screen.getByRole("button", { name: "Open", description: "no board link" });
  await userEvent.tab();
  expect(document.activeElement).toBe(button);
  expect(button.getAttribute("aria-disabled")).toBe("true");
  expect(await screen.findAllByText("no board link")).toHaveLength(2);
  await userEvent.click(button);
  await userEvent.keyboard("{Enter}");
  expect(onPress).not.toHaveBeenCalled();
});

test.each([
  ["pending", "w-pending"],
  ["confirmed", "w-confirmed"],
  ["rejected", "w-rejected"],
  ["timed_out", "w-timed-out"],
  ["sent", "w-sent"],
] satisfies [CommandState, string][])("a %s command is told to screen readers", (state, word) => {
  renderWithWords(
    <Button onPress={() => undefined} state={state}>
      On
    </Button>,
  );
  expect(screen.getByRole("status").textContent).toBe(word);
  expect(screen.getByRole("button", { name: "On", description: word }).dataset["state"]).toBe(state);
});

test("the focus stays on a button through its whole life", async () => {
  const button = (state: CommandState, disabledReason?: string) => (
    <Button onPress={() => undefined} state={state} disabledReason={disabledReason}>
      On
    </Button>
  );
  const { rerender } = renderWithWords(button("idle"));
  await userEvent.tab();
  const focused = document.activeElement;
  for (const next of [button("pending"), button("rejected"), button("idle", "no link"), button("idle")]) {
    rerender(next);
    expect(document.activeElement).toBe(focused);
  }
  expect(focused).toBe(screen.getByRole("button"));
});
