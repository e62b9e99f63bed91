import { render, screen } from "@testing-library/react";
import { createRef } from "react";
import { expect, test } from "vitest";
import { type HeadingHandle, HeadingIndicator } from "./HeadingIndicator";

const CARDINALS = { north: "N", east: "E", south: "S", west: "W" };

function draw() {
  const ref = createRef<HeadingHandle>();
  render(
    <HeadingIndicator
      ref={ref}
      label="Heading"
      noDataText="NO DATA"
      cardinals={CARDINALS}
      describe={(heading_deg, bearing_deg) => `heading ${heading_deg} bug ${bearing_deg}`}
    />,
  );
  const dial = screen.getByRole("img", { name: "Heading" });
  return {
    paint: (...values: Parameters<HeadingHandle["paint"]>) => ref.current?.paint(...values),
    dial,
    bug: dial.querySelector<HTMLElement>(".inst-bug-layer"),
  };
}

test("heading and bearing stand in the attributes, card and bug are turned", () => {
  const { paint, dial, bug } = draw();
  paint(100, 145, 0);
  expect(dial.getAttribute("data-state")).toBe("live");
  expect(dial.getAttribute("data-heading-deg")).toBe("100.0");
  expect(dial.getAttribute("data-bearing-deg")).toBe("145.0");
  expect(dial.querySelector<HTMLElement>(".inst-card")?.style.transform).toBe("rotate(260deg)");
  expect(bug?.style.transform).toBe("rotate(45deg)");
  expect(bug?.hidden).toBe(false);
  expect(dial.querySelector(".inst-description")?.textContent).toBe("heading 100 bug 145");
});

test.each([null, Number.NaN])(
  "without a bearing (%s) there is no bug, and the heading stands",
  (bearing_deg) => {
    const { paint, dial, bug } = draw();
    paint(100, 145, 0);
    paint(101, bearing_deg, 600);
    expect(bug?.hidden).toBe(true);
    expect(dial.hasAttribute("data-bearing-deg")).toBe(false);
    expect(dial.getAttribute("data-heading-deg")).toBe("101.0");
    expect(dial.querySelector(".inst-description")?.textContent).toBe("heading 101 bug null");
  },
);

test.each([null, Number.NaN, Number.POSITIVE_INFINITY])(
  "a heading that is %s is crossed out, bug and all",
  (heading_deg) => {
    const { paint, dial } = draw();
    paint(100, 145, 0);
    paint(heading_deg, 145, 16);
    expect(dial.getAttribute("data-state")).toBe("none");
    expect(dial.hasAttribute("data-heading-deg")).toBe(false);
    expect(dial.hasAttribute("data-bearing-deg")).toBe(false);
  },
);
