import { render } from "@testing-library/react";
import { createRef } from "react";
import { expect, test } from "vitest";
import { Meter, type MeterHandle } from "./Meter";

test.each([
  [0, "normal", "scaleX(0.000)"],
  [34, "normal", "scaleX(0.340)"],
  [92, "high", "scaleX(0.920)"],
  [140, "over", "scaleX(1.000)"],
  [null, "unknown", "scaleX(0.000)"],
  [Number.NaN, "unknown", "scaleX(0.000)"],
] as const)("%d percent is %s", (percent, level, transform) => {
  const ref = createRef<MeterHandle>();
  const { container } = render(<Meter ref={ref} label="RX" />);
  ref.current?.paint(percent, "text");
  const meter = container.querySelector<HTMLElement>(".ui-meter");
  expect(meter?.dataset["level"]).toBe(level);
  expect(meter?.querySelector<HTMLElement>(".ui-meter-fill")?.style.transform).toBe(transform);
  expect(meter?.textContent).toBe("RXtext");
});
