import { render, screen } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { expect, test, vi } from "vitest";
import { TextField } from "./TextField";

test("an edit is committed once, on Enter or on leaving", async () => {
  const onCommit = vi.fn();
  render(<TextField label="Host" value="" onCommit={onCommit} />);
  await userEvent.type(screen.getByRole("textbox", { name: "Host" }), "127.0.0.1");
  expect(onCommit).not.toHaveBeenCalled();
  await userEvent.tab();
  expect(onCommit.mock.calls).toEqual([["127.0.0.1"]]);
});

test("Escape takes the edit back", async () => {
  const onCommit = vi.fn();
  const onEdit = vi.fn();
  render(<TextField label="Host" value="old" onCommit={onCommit} onEdit={onEdit} />);
  const input = screen.getByRole<HTMLInputElement>("textbox", { name: "Host" });
  await userEvent.type(input, "er{Escape}");
  await userEvent.tab();
  expect(input.value).toBe("old");
  expect(onCommit).not.toHaveBeenCalled();
  expect(onEdit.mock.calls).toEqual([["olde"], ["older"], ["old"]]);
});

test("Enter tells the text even when it was not edited", async () => {
  const onEnter = vi.fn();
  render(<TextField label="Line" value="help" onCommit={vi.fn()} onEnter={onEnter} />);
  await userEvent.type(screen.getByRole("textbox", { name: "Line" }), "{Enter}");
  expect(onEnter.mock.calls).toEqual([["help"]]);
});

test("an error is tied to the field", () => {
  render(<TextField label="Host" value="x" onCommit={vi.fn()} hint="an address" error="no such host" />);
  const input = screen.getByRole("textbox", { name: "Host", description: "no such host" });
  expect(input.getAttribute("aria-invalid")).toBe("true");
});

test("disabled, it tells why and takes no text", async () => {
  const onCommit = vi.fn();
  render(<TextField label="Host" value="x" onCommit={onCommit} disabledReason="viewer: no control" />);
  const input = screen.getByRole("textbox", { name: "Host", description: "viewer: no control" });
  await userEvent.type(input, "yz{Enter}");
  expect(onCommit).not.toHaveBeenCalled();
});
