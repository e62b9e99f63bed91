import { render, screen } from "@testing-library/react";
import { createRef } from "react";
import { describe, expect, test } from "vitest";
import { AirspeedIndicator } from "../airspeed/AirspeedIndicator";
import { Altimeter } from "../altitude/Altimeter";
import { VerticalSpeedIndicator } from "../vvi/VerticalSpeedIndicator";
import type { DialHandle } from "./PointerDial";

const INSTRUMENTS = [
  {
    name: "airspeed",
    Dial: AirspeedIndicator,
    attribute: "data-airspeed-kt",
    inside: 55,
    beyond: 171,
    written: "55.0",
  },
  {
    name: "altimeter",
    Dial: Altimeter,
    attribute: "data-altitude-ft",
    inside: 1250,
    beyond: 120_000,
    written: "1250",
  },
  {
    name: "vertical speed",
    Dial: VerticalSpeedIndicator,
    attribute: "data-vertical-speed-ft-min",
    inside: -700,
    beyond: 2600,
    written: "-700",
  },
] as const;

describe.each(INSTRUMENTS)("the $name", ({ Dial, attribute, inside, beyond, written }) => {
  function draw() {
    const ref = createRef<DialHandle>();
    render(
      <Dial
        ref={ref}
        label="Dial"
        noDataText="NO DATA"
        caption="CAPTION"
        unit="unit"
        offScaleText="OFF SCALE"
        format={(value) => value.toFixed(0)}
        describe={(value) => `it is ${value}`}
      />,
    );
    const dial = screen.getByRole("img", { name: "Dial" });
    return {
      paint: (...values: Parameters<DialHandle["paint"]>) => ref.current?.paint(...values),
      dial,
      pointer: () => dial.querySelector<HTMLElement>(".inst-layer")?.style.transform,
      number: () => dial.querySelector(".inst-window-number")?.textContent,
    };
  }

  test("draws its words and figures over the pointer, which covers none of them", () => {
    const { dial } = draw();
    const pointer = dial.querySelector(".inst-pointer");
    const words = [...dial.querySelectorAll("text")];
    expect(words.map(({ textContent }) => textContent)).toContain("CAPTION");
    for (const word of words) {
      const isAfter = (pointer?.compareDocumentPosition(word) ?? 0) & Node.DOCUMENT_POSITION_FOLLOWING;
      expect([word.textContent, isAfter !== 0]).toEqual([word.textContent, true]);
    }
  });

  test("shows no data until something was painted", () => {
    const { dial } = draw();
    expect(dial.getAttribute("data-state")).toBe("none");
    expect(screen.getByText("NO DATA")).toBeDefined();
  });

  test("turns its pointer, writes the number and carries the exact value", () => {
    const { paint, dial, pointer, number } = draw();
    paint(inside, 0);
    expect(dial.getAttribute("data-state")).toBe("live");
    expect(dial.getAttribute(attribute)).toBe(written);
    expect(dial.getAttribute("data-reach")).toBe("within");
    expect(pointer()).toMatch(/^rotate\(-?[\d.]+deg\)$/);
    expect(number()).toBe(inside.toFixed(0));
    expect(dial.querySelector(".inst-description")?.textContent).toBe(`it is ${inside}`);
  });

  test("stops at its end, says so, and still gives the whole number", () => {
    const { paint, dial, pointer, number } = draw();
    paint(beyond, 0);
    const atEnd = pointer();
    expect(dial.getAttribute("data-reach")).toBe("above");
    expect(number()).toBe(beyond.toFixed(0));
    paint(beyond * 3, 500);
    expect(pointer()).toBe(atEnd);
    paint(inside, 1000);
    expect(dial.getAttribute("data-reach")).toBe("within");
  });

  test("moves its pointer each animation frame but rewrites the number ten times a second", () => {
    const { paint, pointer, number } = draw();
    paint(inside, 0);
    const before = pointer();
    paint(inside + 10, 16);
    expect(pointer()).not.toBe(before);
    expect(number()).toBe(inside.toFixed(0));
    paint(inside + 10, 100);
    expect(number()).toBe((inside + 10).toFixed(0));
  });

  test.each([null, Number.NaN, Number.NEGATIVE_INFINITY])("crosses out %s instead of drawing it", (value) => {
    const { paint, dial } = draw();
    paint(beyond, 0);
    paint(value, 16);
    expect(dial.getAttribute("data-state")).toBe("none");
    expect(dial.hasAttribute(attribute)).toBe(false);
    expect(dial.hasAttribute("data-reach")).toBe(false);
    expect(dial.querySelector(".inst-description")?.textContent).toBe("NO DATA");
  });
});
