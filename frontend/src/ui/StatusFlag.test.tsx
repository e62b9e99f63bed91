import { screen } from "@testing-library/react";
import { expect, test } from "vitest";
import { StatusFlag } from "./StatusFlag";
import { renderWithWords } from "./test/testWords";

test.each([
  [true, "w-on", "on"],
  [false, "w-off", "off"],
  [null, "w-unknown", "unknown"],
] as const)("a flag that is %s says so in words", (value, word, state) => {
  const { container } = renderWithWords(<StatusFlag label="GPS" value={value} />);
  expect(screen.getByText(word)).toBeDefined();
  expect(container.querySelector<HTMLElement>(".ui-flag")?.dataset["state"]).toBe(state);
});

test("a stale flag keeps its last word and adds that it is stale", () => {
  const { container } = renderWithWords(
    <StatusFlag label="GPS" value stale texts={{ on: "flying", off: "waiting" }} />,
  );
  expect(container.textContent).toBe("GPSflying w-stale");
});
