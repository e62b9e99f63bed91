import { render } from "@testing-library/react";
import { createRef } from "react";
import { expect, test } from "vitest";
import { SteadyText, type SteadyTextHandle } from "./SteadyText";

function draw(chars: number) {
  const ref = createRef<SteadyTextHandle>();
  const ui = (className: string) => <SteadyText ref={ref} chars={chars} initial="–" className={className} />;
  const { container, rerender } = render(ui("one"));
  const room = container.querySelector<HTMLElement>(".ui-steady");
  return {
    write: (text: string) => ref.current?.write(text),
    text: () => container.textContent,
    node: () => container.querySelector(".ui-steady-text")?.firstChild,
    width_em: () => Number.parseFloat(room?.style.width ?? ""),
    renderAgain: () => rerender(ui("two")),
  };
}

test("a text takes the place of the one before, in the same node", () => {
  const { write, text, node } = draw(4);
  expect(text()).toBe("–");
  const first = node();
  write("12.5");
  write("-3.0");
  expect(text()).toBe("-3.0");
  expect(node()).toBe(first);
});

test("a text longer than its room gets more room, and the room is not taken back", () => {
  const { write, width_em } = draw(4);
  const before = width_em();
  write("1.0");
  expect(width_em()).toBe(before);
  write("-12345678.9");
  const grown = width_em();
  expect(grown).toBeCloseTo((before / 4) * 11, 6);
  write("1.0");
  expect(width_em()).toBe(grown);
});

test("a render of the page leaves what was written as it is", () => {
  const { write, text, renderAgain } = draw(4);
  write("7.0");
  renderAgain();
  expect(text()).toBe("7.0");
});
