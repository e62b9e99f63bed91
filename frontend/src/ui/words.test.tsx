import { render, screen } from "@testing-library/react";
import { expect, test, vi } from "vitest";
import { StatusFlag } from "./StatusFlag";
import { WORDS } from "./test/testWords";
import type { CommandState, DataState } from "./words";
import { commandWord, dataWord, WordsProvider } from "./words";

test("every state but rest has a word of its own", () => {
  const commands: CommandState[] = ["pending", "confirmed", "rejected", "timed_out", "sent"];
  const data: DataState[] = ["live", "stale", "none"];
  const words = [
    ...commands.map((state) => commandWord(WORDS, state)),
    ...data.map((state) => dataWord(WORDS, state)),
  ];
  expect(new Set(words).size).toBe(words.length);
  expect(words).not.toContain("");
  expect(commandWord(WORDS, "idle")).toBe("");
});

test("a change of language reaches the controls", () => {
  const flag = <StatusFlag label="GPS" value />;
  const { rerender } = render(<WordsProvider words={WORDS}>{flag}</WordsProvider>);
  rerender(<WordsProvider words={{ ...WORDS, on: "encendido" }}>{flag}</WordsProvider>);
  expect(screen.getByText("encendido")).toBeDefined();
});

test("a control without words above it fails at once instead of showing none", () => {
  vi.spyOn(console, "error").mockImplementation(() => undefined);
  expect(() => render(<StatusFlag label="GPS" value />)).toThrow("WordsProvider");
});
