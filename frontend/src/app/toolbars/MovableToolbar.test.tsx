import { act, fireEvent, screen } from "@testing-library/react";
import { beforeEach, expect, test } from "vitest";
import { choose } from "../../store/settings";
import { Station } from "../../test/station";
import { placeKey } from "./MovableToolbar";

let station: Station;

beforeEach(() => {
  station = new Station();
  station.greet();
});

function handle(): HTMLElement {
  return screen.getByLabelText("Mover la barra Piloto automático");
}

function dock(): string | undefined {
  return handle().closest<HTMLElement>(".app-dock")?.dataset["edge"];
}

function remembered(): string | undefined {
  return station.page.settings.getState().choices[placeKey("automatic")];
}

test("arrow keys take a toolbar to an edge, and its handle keeps the focus", () => {
  handle().focus();
  for (const [key, edge] of [
    ["ArrowLeft", "left"],
    ["ArrowDown", "bottom"],
    ["ArrowRight", "right"],
    ["ArrowUp", "top"],
  ] as const) {
    fireEvent.keyDown(handle(), { key });
    expect(dock()).toBe(edge);
    expect(document.activeElement).toBe(handle());
    expect(remembered()).toBe(edge);
  }
});

test("the controls go with their toolbar, and the other toolbar stays", () => {
  handle().focus();
  fireEvent.keyDown(handle(), { key: "ArrowLeft" });
  expect(screen.getByLabelText("Piloto automático").textContent).toContain("Autotrim");
  expect(
    screen.getByLabelText("Mover la barra Señal de control").closest<HTMLElement>(".app-dock")?.dataset[
      "edge"
    ],
  ).toBe("top");
});

test("a floating toolbar stands at its share of the room, and arrow keys push it", () => {
  act(() => choose(station.page.settings, placeKey("automatic"), "0.5000 0.2500"));
  expect(dock()).toBe("floating");
  const bar = handle().closest<HTMLElement>(".app-movable");
  expect([bar?.style.getPropertyValue("--x"), bar?.style.getPropertyValue("--y")]).toEqual(["0.5", "0.25"]);
  fireEvent.keyDown(handle(), { key: "ArrowRight" });
  expect(remembered()).toBe("0.5200 0.2500");
});

/** jsdom has no pointer events: a mouse event of the same name replaces them. */
function point(type: string, x: number, y: number): void {
  fireEvent(
    handle(),
    Object.assign(new MouseEvent(type, { bubbles: true, clientX: x, clientY: y, button: 0 }), {
      pointerId: 1,
    }),
  );
}

test("a drag puts it where it is let go: floating, or at the edge that is near", () => {
  Element.prototype.setPointerCapture ??= () => undefined;
  point("pointerdown", 10, 10);
  point("pointermove", 300, 300);
  expect(handle().closest<HTMLElement>(".app-movable")?.dataset["dragged"]).toBe("floating");
  point("pointerup", 300, 300);
  expect(dock()).toBe("floating");
  point("pointerdown", 300, 300);
  point("pointermove", window.innerWidth - 5, 300);
  point("pointerup", window.innerWidth - 5, 300);
  expect(dock()).toBe("right");
});

test("a press without a drag opens the places to choose from", () => {
  point("pointerdown", 10, 10);
  point("pointerup", 11, 10);
  fireEvent.click(handle());
  fireEvent.click(screen.getByText("Flotante"));
  expect(dock()).toBe("floating");
});
