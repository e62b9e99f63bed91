import { render, screen } from "@testing-library/react";
import { createRef } from "react";
import { expect, test } from "vitest";
import { Readout, ReadoutGrid, type ReadoutHandle } from "./Readout";
import { renderWithWords, WORDS } from "./test/testWords";
import { WordsProvider } from "./words";

function draw() {
  const ref = createRef<ReadoutHandle>();
  const list = (label: string) => (
    <ReadoutGrid>
      <Readout ref={ref} label={label} unit="deg" />
    </ReadoutGrid>
  );
  const { rerender } = renderWithWords(list("Roll"));
  const value = () => screen.getByRole("definition");
  return {
    paint: (...values: Parameters<ReadoutHandle["paint"]>) => ref.current?.paint(...values),
    value,
    state: () => value().parentElement?.dataset["state"],
    rename: (label: string) => rerender(list(label)),
  };
}

test("before anything was painted it has no data, and no zero", () => {
  const { value, state } = draw();
  expect(screen.getByRole("term").textContent).toBe("Roll");
  expect(state()).toBe("none");
  expect(value().textContent).toContain("w-no-data");
  expect(value().textContent).not.toMatch(/\d/);
});

test("a live number stands with its unit and nothing else", () => {
  const { paint, value, state } = draw();
  paint("-12.3", "live");
  expect(value().textContent).toBe("-12.3deg");
  expect(state()).toBe("live");
});

test("a stale number stays readable and says that it is stale", () => {
  const { paint, value, state } = draw();
  paint("-12.3", "stale");
  expect(value().textContent).toBe("-12.3degw-stale");
  expect(state()).toBe("stale");
});

test.each([
  [null, "live"],
  ["7.0", "none"],
] as const)("no number (%s, %s) is no data and shows no digit", (text, state) => {
  const { paint, value } = draw();
  paint("1.0", "live");
  paint(text, state);
  expect(value().textContent).toContain("w-no-data");
  expect(value().textContent).not.toMatch(/\d/);
});

test("a number longer than its room is whole", () => {
  const { paint, value } = draw();
  paint("-123456789.01", "live");
  expect(value().textContent).toContain("-123456789.01");
});

test("a render of the page leaves what was painted as it is", () => {
  const { paint, value, state, rename } = draw();
  paint("5.0", "stale");
  rename("Alabeo");
  expect(screen.getByRole("term").textContent).toBe("Alabeo");
  expect(value().textContent).toBe("5.0degw-stale");
  expect(state()).toBe("stale");
});

test("in another language it says the same state at once", () => {
  const ref = createRef<ReadoutHandle>();
  const inWords = (stale: string) => (
    <WordsProvider words={{ ...WORDS, stale }}>
      <ReadoutGrid>
        <Readout ref={ref} label="Roll" />
      </ReadoutGrid>
    </WordsProvider>
  );
  const { rerender } = render(inWords("viejo"));
  ref.current?.paint("-12.3", "stale");
  rerender(inWords("old"));
  const value = screen.getByRole("definition");
  expect(value.textContent).toBe("-12.3old");
  expect(value.parentElement?.dataset["state"]).toBe("stale");
});
