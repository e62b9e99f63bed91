import { render, screen } from "@testing-library/react";
import { expect, test } from "vitest";
import { ControlPath } from "./ControlPath";
import type { Switches } from "./geometry";

const LABELS = {
  joystick: "Stick",
  rc: "Radio",
  manual: "Manual",
  assisted: "Assisted",
  computer: "Computer",
  autopilot: "Autopilot",
  surfaces: "Surfaces",
  ignored: "ignored",
  unknown: "unknown",
};

function draw(switches: Switches) {
  render(<ControlPath label="Control path" description="in one sentence" labels={LABELS} {...switches} />);
  return screen.getByRole("img", { name: "Control path" });
}

function box(name: string): Element | null {
  return screen.getByText(name).closest(".inst-path-box");
}

test("the live way is marked on the stations it passes", () => {
  const picture = draw({ source: "joystick", path: "manual", autopilot: false });
  expect(picture.dataset["source"]).toBe("joystick");
  expect(picture.dataset["path"]).toBe("manual");
  expect(box("Stick")?.getAttribute("data-live")).toBe("true");
  expect(box("Radio")?.getAttribute("data-live")).toBe("false");
  expect(box("Computer")?.getAttribute("data-live")).toBe("false");
  expect(box("Surfaces")?.getAttribute("data-live")).toBe("true");
  expect(picture.querySelector("desc")?.textContent).toBe("in one sentence");
});

test("automatic flight says in words that stick and transmitter are ignored", () => {
  draw({ source: "rc", path: "assisted", autopilot: true });
  expect(screen.getByText("ignored")).toBeDefined();
  expect(box("Stick")?.getAttribute("data-ignored")).toBe("true");
  expect(box("Radio")?.getAttribute("data-ignored")).toBe("true");
  expect(box("Autopilot")?.getAttribute("data-live")).toBe("true");
});

test("piloted flight does not", () => {
  draw({ source: "rc", path: "assisted", autopilot: false });
  expect(screen.queryByText("ignored")).toBeNull();
  expect(box("Radio")?.getAttribute("data-ignored")).toBe("false");
});

test("positions that nobody knows are shown as such", () => {
  const picture = draw({ source: null, path: null, autopilot: null });
  expect(picture.dataset["source"]).toBe("unknown");
  expect(picture.dataset["path"]).toBe("unknown");
  expect(screen.getByText("unknown")).toBeDefined();
  expect(picture.querySelectorAll('[data-known="false"]')).toHaveLength(2);
  expect(picture.querySelectorAll('[data-live="true"]')).toHaveLength(0);
});
