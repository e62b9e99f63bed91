import { render, screen } from "@testing-library/react";
import { createRef } from "react";
import { expect, test } from "vitest";
import { ServoBar, type ServoBarHandle } from "./ServoBar";

function draw() {
  const ref = createRef<ServoBarHandle>();
  render(<ServoBar ref={ref} label="Rudder" noDataText="no data" format={(value) => value.toFixed(2)} />);
  const bar = screen.getByRole("group", { name: "Rudder" });
  return {
    paint: (...values: Parameters<ServoBarHandle["paint"]>) => ref.current?.paint(...values),
    bar,
    marker: () => bar.querySelector<HTMLElement>(".inst-servo-marker")?.style.transform,
    number: () => bar.querySelector(".inst-servo-number")?.textContent,
  };
}

test("the position stands in the attribute, the number and the bar", () => {
  const { paint, bar, marker, number } = draw();
  paint(0.5, 0);
  expect(bar.getAttribute("data-state")).toBe("live");
  expect(bar.getAttribute("data-value")).toBe("0.500");
  expect(bar.getAttribute("data-limited")).toBe("false");
  expect(number()).toBe("0.50");
  expect(marker()).toBe("translateY(-75.00%)");
});

test("the bar follows each animation frame, the number ten times a second", () => {
  const { paint, marker, number } = draw();
  paint(0, 0);
  paint(1, 16);
  expect(marker()).toBe("translateY(-100.00%)");
  expect(number()).toBe("0.00");
  paint(1, 101);
  expect(number()).toBe("1.00");
});

test.each([null, Number.NaN])("%s is no position: nothing is drawn at the middle", (value) => {
  const { paint, bar, number } = draw();
  paint(0.5, 0);
  paint(value, 16);
  expect(bar.getAttribute("data-state")).toBe("none");
  expect(bar.hasAttribute("data-value")).toBe(false);
  expect(bar.hasAttribute("data-limited")).toBe(false);
  expect(number()).toBe("");
  expect(screen.getByText("no data")).toBeDefined();
});
