import { act, screen } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { beforeEach, describe, expect, test } from "vitest";
import type { Waypoint } from "../../lib/plan";
import { boardHas, editPlan, MISSIONS } from "../../missions/planDrafts";
import { aStatus, heldBy } from "../../test/aStatus";
import { type FakeRequest, Station } from "../../test/station";
import { WORDS } from "../../ui/test/testWords";
import { WordsProvider } from "../../ui/words";
import { PlanMap } from "./PlanMap";
import { MAP_TOOL } from "./tools/mapTool";

// The flat map, whose middle is at 0, 0 where a document has no layout.
const user = userEvent.setup();
let station: Station;
const plan: readonly Waypoint[] = [
  { latitude_deg: 27.95, longitude_deg: -15.4, altitude_ft: 700, speed_kt: 55 },
  { latitude_deg: 27.95, longitude_deg: -15.36, altitude_ft: 1000, speed_kt: 60 },
];

beforeEach(() => {
  station = new Station(
    <WordsProvider words={WORDS}>
      <PlanMap plan="flight" />
    </WordsProvider>,
  );
  HTMLCanvasElement.prototype.setPointerCapture = () => undefined;
  station.greet();
});

/** The board and the table have this plan, and the map shows all of it. */
function given(waypoints: readonly Waypoint[] = plan): void {
  const { plans } = station.page.parts.get(MISSIONS);
  act(() => {
    boardHas(plans, "flight", waypoints);
    editPlan(plans, "flight", waypoints);
  });
  station.show();
}

function draft(): readonly Waypoint[] {
  return station.page.parts.get(MISSIONS).plans.getState().flight.draft.present;
}

function map(): HTMLElement {
  const found = document.querySelector<HTMLElement>(".map-flat");
  if (found === null) throw new Error("there is no flat map");
  return found;
}

/** A press of a mouse button on the map, so many pixels from its middle. */
function press(x: number, y: number, { button = 0, shiftKey = false } = {}): void {
  const canvas = map().querySelector("canvas");
  for (const type of ["pointerdown", "pointerup"]) {
    const event = new PointerEvent(type, {
      pointerId: 1,
      isPrimary: true,
      button,
      shiftKey,
      pointerType: "mouse",
      bubbles: true,
    });
    Object.defineProperties(event, { offsetX: { value: x }, offsetY: { value: y } });
    act(() => void canvas?.dispatchEvent(event));
  }
  station.show();
}

/** By their names: a search by role through the whole panel takes seconds. */
function button(name: string | RegExp): HTMLElement {
  const found = [...document.querySelectorAll<HTMLElement>("button, [role=menuitem]")].find((element) => {
    const known =
      element.ariaLabel ?? element.querySelector(".ui-menu-label")?.textContent ?? element.textContent;
    return typeof name === "string" ? known === name : name.test(known);
  });
  if (found === undefined) throw new Error(`there is no button ${name}`);
  return found;
}

function isDisabled(name: string | RegExp): boolean {
  const found = button(name);
  return found.ariaDisabled === "true" || found.hasAttribute("data-disabled");
}

async function opened(x: number, y: number): Promise<void> {
  press(x, y, { button: 2 });
  await screen.findByRole("menu");
}

function newest(method: string): FakeRequest {
  const asked = station.asked.filter((one) => one.method === method).at(-1);
  if (asked === undefined) throw new Error(`nothing was asked with ${method}`);
  return asked;
}

describe("while points are added", () => {
  test("each press puts a waypoint where it was, and undo takes the last one back", async () => {
    await user.click(button("Añadir puntos"));
    press(0, 0);
    press(200, 0);
    const [one, two] = draft();
    expect(draft()).toHaveLength(2);
    expect(two?.latitude_deg).toBeCloseTo(one?.latitude_deg ?? 0, 6);
    expect(two?.longitude_deg).toBeGreaterThan((one?.longitude_deg ?? 0) + 0.01);
    await user.click(button("Deshacer en el mapa"));
    expect(draft()).toEqual([one]);
  });

  test("a press on a leg goes into it", async () => {
    await user.click(button("Añadir puntos"));
    press(-200, 0);
    press(200, 0);
    press(0, 3);
    expect(draft()).toHaveLength(3);
    const longitudes = draft().map(({ longitude_deg }) => longitude_deg);
    expect(longitudes).toEqual([...longitudes].sort((one, other) => one - other));
  });

  test("a full plan takes no more, and says so", async () => {
    given(
      Array.from({ length: 100 }, (_, row) => ({
        ...plan[0],
        longitude_deg: -15.4 - row / 100,
      })) as Waypoint[],
    );
    await user.click(button("Añadir puntos"));
    expect(document.querySelector(".map-edit-hint")?.textContent).toBe(
      "Un plan tiene como mucho 100 waypoints.",
    );
    press(0, 200);
    expect(draft()).toHaveLength(100);
  });

  test("Escape ends it: a press then adds nothing", async () => {
    await user.click(button("Añadir puntos"));
    map().focus();
    await user.keyboard("{Escape}");
    press(0, 0);
    expect(draft()).toEqual([]);
  });
});

describe("the keyboard alone", () => {
  test("adds at the cross, selects, moves and deletes a waypoint", async () => {
    map().focus();
    await user.keyboard("{Insert}{ArrowRight}{ArrowRight}{ArrowRight}{Insert}");
    expect(draft()).toHaveLength(2);
    const [one] = draft();
    await user.keyboard("n{Alt>}{ArrowUp}{PageUp}{/Alt}");
    expect(draft()[0]?.latitude_deg).toBeCloseTo((one?.latitude_deg ?? 0) + 10 / 111_195, 6);
    expect(draft()[0]?.altitude_ft).toBe((one?.altitude_ft ?? 0) + 10);
    await user.keyboard("{Delete}");
    expect(draft()).toHaveLength(1);
    await user.keyboard("{Control>}z{/Control}");
    expect(draft()).toHaveLength(2);
  });

  test("opens the menu of the middle, and of the waypoint that is selected", async () => {
    given();
    map().focus();
    await user.keyboard("{ContextMenu}");
    expect((await screen.findByRole("menu")).textContent).toContain("Añadir waypoint aquí");
    await user.keyboard("{Escape}");
    map().focus();
    await user.keyboard("n");
    await user.keyboard("{Shift>}{F10}{/Shift}");
    expect((await screen.findByRole("menu")).textContent).toContain("Quitar el waypoint 1");
  });
});

describe("the menu of a place", () => {
  test("adds a waypoint there, and measures from there", async () => {
    given();
    await opened(150, 90);
    await user.click(button("Añadir waypoint aquí"));
    expect(draft()).toHaveLength(3);
    await opened(-90, 150);
    await user.click(button("Medir desde aquí"));
    press(0, 150);
    expect(station.page.parts.get(MAP_TOOL).getState().measured).toHaveLength(2);
  });

  test("turns the plan round", async () => {
    given();
    await opened(150, 90);
    await user.click(button("Invertir el plan"));
    expect(draft().map(({ longitude_deg }) => longitude_deg)).toEqual([-15.36, -15.4]);
  });
});

describe("flying to a place", () => {
  test("asks first, sends the plan with it before the next waypoint, and then commands it", async () => {
    given();
    station.send({ fms_plan: { waypoint: 1 }, heartbeat: { autopilot: true } });
    await opened(150, 90);
    await user.click(button("Volar aquí…"));
    expect((await screen.findByRole("dialog")).textContent).toContain("se envía el plan a la placa");
    expect(station.asked.filter(({ method }) => method !== "GET")).toEqual([]);
    await user.click(button("Ir y seguir al 2"));
    const sent = newest("PUT");
    expect(draft()).toHaveLength(3);
    expect(draft()[1]).toMatchObject({ altitude_ft: 1000, speed_kt: 60 });
    expect(sent.body).toEqual({ waypoints: draft() });
    await sent.answer({ plan: "flight", waypoints: draft() });
    expect(newest("POST").path).toContain("go_to_waypoint");
    expect(newest("POST").body).toEqual({ value: { plan: 0, index: 1 } });
  });

  test("and holding there puts it behind all others", async () => {
    given();
    station.send({ fms_plan: { waypoint: 0 } });
    await opened(150, 90);
    await user.click(button("Volar aquí…"));
    await user.click(button("Ir y esperar allí"));
    expect(draft().slice(0, 2)).toEqual(plan);
    await newest("PUT").answer({ plan: "flight", waypoints: draft() });
    expect(newest("POST").body).toEqual({ value: { plan: 0, index: 2 } });
  });

  test("is not offered without control, nor while nobody knows what the board has", async () => {
    await opened(150, 90);
    expect(isDisabled("Volar aquí…")).toBe(true);
    expect(document.body.textContent).toContain("No se sabe qué plan tiene la placa");
    await user.keyboard("{Escape}");
    given();
    await opened(150, 90);
    expect(isDisabled("Volar aquí…")).toBe(false);
    await user.keyboard("{Escape}");
    station.status(aStatus({ control: heldBy("c2", "otra") }));
    await opened(150, 90);
    expect(isDisabled("Volar aquí…")).toBe(true);
  });
});
