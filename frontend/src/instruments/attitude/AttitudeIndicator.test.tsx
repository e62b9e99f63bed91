import { render, screen } from "@testing-library/react";
import { createRef } from "react";
import { expect, test } from "vitest";
import { type AttitudeHandle, AttitudeIndicator } from "./AttitudeIndicator";

const describeAttitude = (pitch_deg: number, roll_deg: number): string =>
  `pitch ${pitch_deg} roll ${roll_deg}`;

function draw() {
  const ref = createRef<AttitudeHandle>();
  const ui = (label: string) => (
    <AttitudeIndicator ref={ref} label={label} noDataText="NO DATA" describe={describeAttitude} />
  );
  const { rerender } = render(ui("Attitude"));
  return {
    paint: (...values: Parameters<AttitudeHandle["paint"]>) => ref.current?.paint(...values),
    dial: () => screen.getByRole("img"),
    transformOf: (selector: string) =>
      screen.getByRole("img").querySelector<HTMLElement>(selector)?.style.transform,
    rename: (label: string) => rerender(ui(label)),
  };
}

test("it shows no data until something was painted", () => {
  const { dial } = draw();
  expect(dial().getAttribute("aria-label")).toBe("Attitude");
  expect(dial().getAttribute("data-state")).toBe("none");
  expect(dial().hasAttribute("data-roll-deg")).toBe(false);
  expect(screen.getByText("NO DATA")).toBeDefined();
});

test("the painted attitude stands in the attributes and turns the horizon", () => {
  const { paint, dial, transformOf } = draw();
  paint({ pitch_deg: 5, roll_deg: 30 }, 0);
  expect(dial().getAttribute("data-state")).toBe("live");
  expect(dial().getAttribute("data-pitch-deg")).toBe("5.0");
  expect(dial().getAttribute("data-roll-deg")).toBe("30.0");
  expect(transformOf(".inst-ladder")).toBe("rotate(330deg) translate(0cqmin, 5.75cqmin)");
  expect(transformOf(".inst-horizon")).toBe("rotate(330deg) translate(0cqmin, 5.75cqmin)");
  expect(transformOf(".inst-roll-pointer")).toBe("rotate(330deg)");
});

test.each([[null], [{ pitch_deg: null, roll_deg: 1 }], [{ pitch_deg: Number.NaN, roll_deg: Number.NaN }]])(
  "an attitude that is not there (%j) is crossed out and not drawn as level flight",
  (attitude) => {
    const { paint, dial } = draw();
    paint({ pitch_deg: 5, roll_deg: 30 }, 0);
    paint(attitude, 16);
    expect(dial().getAttribute("data-state")).toBe("none");
    expect(dial().hasAttribute("data-pitch-deg")).toBe(false);
    expect(dial().hasAttribute("data-roll-deg")).toBe(false);
    expect(dial().querySelector(".inst-description")?.textContent).toBe("NO DATA");
  },
);

test("a render of the page leaves what was painted as it is", () => {
  const { paint, dial, rename, transformOf } = draw();
  paint({ pitch_deg: -3, roll_deg: 12 }, 0);
  rename("Actitud");
  expect(dial().getAttribute("aria-label")).toBe("Actitud");
  expect(dial().getAttribute("data-state")).toBe("live");
  expect(dial().getAttribute("data-roll-deg")).toBe("12.0");
  expect(transformOf(".inst-ladder")).toContain("rotate(348deg)");
});

test("the description follows twice a second, and at once when the data come back", () => {
  const { paint, dial } = draw();
  const told = () => dial().querySelector(".inst-description")?.textContent;
  paint({ pitch_deg: 1, roll_deg: 2 }, 1000);
  expect(told()).toBe("pitch 1 roll 2");
  paint({ pitch_deg: 9, roll_deg: 9 }, 1499);
  expect(told()).toBe("pitch 1 roll 2");
  paint({ pitch_deg: 9, roll_deg: 9 }, 1500);
  expect(told()).toBe("pitch 9 roll 9");
  paint(null, 1510);
  paint({ pitch_deg: 4, roll_deg: 4 }, 1520);
  expect(told()).toBe("pitch 4 roll 4");
});
