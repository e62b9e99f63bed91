import { render, screen } from "@testing-library/react";
import { createRef } from "react";
import { expect, test } from "vitest";
import { ControlCross, type ControlCrossHandle } from "./ControlCross";

const STICK = { aileron: 0.25, elevator: -0.5, rudder: 0, throttle: 0.7 };

function draw() {
  const ref = createRef<ControlCrossHandle>();
  render(
    <ControlCross
      ref={ref}
      label="Stick"
      noDataText="NO DATA"
      describe={({ elevator }) => `elevator ${elevator}`}
    />,
  );
  return {
    paint: (...values: Parameters<ControlCrossHandle["paint"]>) => ref.current?.paint(...values),
    picture: screen.getByRole("img", { name: "Stick" }),
  };
}

test("the four controls stand in the attributes", () => {
  const { paint, picture } = draw();
  expect(picture.getAttribute("data-state")).toBe("none");
  paint(STICK, 0);
  expect(picture.getAttribute("data-state")).toBe("live");
  expect(picture.getAttribute("data-aileron")).toBe("0.250");
  expect(picture.getAttribute("data-elevator")).toBe("-0.500");
  expect(picture.getAttribute("data-rudder")).toBe("0.000");
  expect(picture.getAttribute("data-throttle")).toBe("0.700");
  expect(picture.querySelector(".inst-description")?.textContent).toBe("elevator -0.5");
  const [stick, pedals, throttle] = picture.querySelectorAll<HTMLElement>(".inst-layer");
  expect(stick?.style.transform).toBe("translate(8.333cqmin, -16.667cqmin)");
  expect(pedals?.style.transform).toBe("none");
  expect(throttle?.style.transform).toBe("translate(0cqmin, -46.667cqmin)");
});

test.each([null, { ...STICK, rudder: null }, { ...STICK, aileron: Number.NaN }])(
  "%j is crossed out and not drawn as a centred stick",
  (controls) => {
    const { paint, picture } = draw();
    paint(STICK, 0);
    paint(controls, 16);
    expect(picture.getAttribute("data-state")).toBe("none");
    expect(picture.hasAttribute("data-aileron")).toBe(false);
    expect(picture.querySelector(".inst-description")?.textContent).toBe("NO DATA");
  },
);
