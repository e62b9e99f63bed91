import { act, screen, within } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { describe, expect, test } from "vitest";
import type { Waypoint } from "../../lib/plan";
import { editPlan, MISSIONS } from "../../missions/planDrafts";
import { SELECTION } from "../../missions/selection";
import { aStatus } from "../../test/aStatus";
import { type FakeRequest, Station } from "../../test/station";
import { WORDS } from "../../ui/test/testWords";
import { WordsProvider } from "../../ui/words";
import { PlanSection } from "./PlanSection";
import { ThingCard } from "./ThingCard";
import { ThingsSection } from "./ThingsSection";

const user = userEvent.setup();
let station: Station;
const plan: readonly Waypoint[] = [
  { latitude_deg: 27.9515, longitude_deg: -15.3741, altitude_ft: 700, speed_kt: 55 },
  { latitude_deg: 27.9503, longitude_deg: -15.3573, altitude_ft: 1000, speed_kt: 55 },
  { latitude_deg: 27.9239, longitude_deg: -15.3707, altitude_ft: 1000, speed_kt: 60 },
];

function open(status = aStatus()): void {
  station = new Station(
    <WordsProvider words={WORDS}>
      <ThingsSection />
      <PlanSection />
      <ThingCard />
    </WordsProvider>,
  );
  station.greet(status);
}

async function downloaded(): Promise<void> {
  open();
  await user.click(screen.getByLabelText("Plan real"));
  await user.click(button("Leer"));
  await newest("GET", /missions\/flight$/).answer({ plan: "flight", waypoints: plan });
}

function newest(method: string, path: RegExp): FakeRequest {
  const asked = station.asked.filter((one) => one.method === method && path.test(one.path)).at(-1);
  if (asked === undefined) throw new Error(`the page asked nothing with ${method} ${path}`);
  return asked;
}

/** Only by its name: a search by role through this panel takes seconds. */
function button(name: string | RegExp): HTMLElement {
  const found = [...document.querySelectorAll("button")].filter(({ ariaLabel, textContent }) => {
    const known = ariaLabel ?? textContent;
    return typeof name === "string" ? known === name : name.test(known);
  });
  const [only] = found;
  if (only === undefined || found.length > 1) throw new Error(`${found.length} buttons "${name}"`);
  return only;
}

async function chooseWaypoint(row: number): Promise<void> {
  await user.selectOptions(screen.getByLabelText("Waypoint", { selector: "select" }), String(row));
}

function draft(): readonly Waypoint[] {
  return station.page.parts.get(MISSIONS).plans.getState().flight.draft.present;
}

describe("a waypoint that is chosen", () => {
  test("is pushed by keys in metres and feet, and a held key is one step of the undo", async () => {
    await downloaded();
    await chooseWaypoint(1);
    button("Al norte").focus();
    await user.keyboard("{ArrowUp}");
    const once = draft()[1]?.latitude_deg ?? 0;
    // 10 m of a degree of latitude, to 0.1 m.
    expect(once - 27.9503).toBeCloseTo(10 / 111_195, 6);
    await user.keyboard("{PageUp>3/}");
    expect(draft()[1]?.altitude_ft).toBe(1030);
    await user.click(button("Deshacer"));
    expect(draft()[1]?.altitude_ft).toBe(1000);
    expect(draft()[1]?.latitude_deg).toBe(once);
    await user.click(button("Deshacer"));
    expect(draft()).toEqual(plan);
    expect(document.querySelector(".map-plan-state")?.textContent).toContain("igual que en la placa");
  });

  test("is edited as a number, inserted after and deleted", async () => {
    await downloaded();
    await chooseWaypoint(0);
    const altitude = screen.getByLabelText("Altura", { selector: "input" });
    await user.clear(altitude);
    await user.type(altitude, "850{Enter}");
    expect(draft()[0]?.altitude_ft).toBe(850);
    await user.click(button("Insertar tras 1"));
    expect(draft()).toHaveLength(4);
    await user.click(button("Quitar"));
    expect(draft()).toEqual([{ ...plan[0], altitude_ft: 850 }, plan[1], plan[2]]);
  });

  test("shows its values in a card that Escape closes", async () => {
    await downloaded();
    await chooseWaypoint(2);
    const card = screen.getByRole("region", { name: "Waypoint 3 · Plan de vuelo (FMS)" });
    expect(card.textContent).toContain("27.923900°");
    expect(card.textContent).toContain("Igual que en la placa.");
    await user.keyboard("{Escape}");
    expect(screen.queryByRole("region", { name: /Waypoint 3/ })).toBeNull();
  });
});

describe("an edited plan", () => {
  /** The model that flies a plan before it is sent finds nothing. */
  const clean = {
    time_s: 600,
    last: 2,
    ground: "whole",
    heights: [],
    fence: true,
    battery: true,
    findings: [],
  };

  test("is sent, and is the board's only when that was read back", async () => {
    await downloaded();
    await chooseWaypoint(0);
    button("Al este").focus();
    await user.keyboard("{ArrowRight}");
    expect(screen.getByRole("region", { name: /Waypoint 1/ }).textContent).toContain(
      "Sin enviar a la placa.",
    );
    await user.click(button("Enviar"));
    await newest("POST", /missions\/rehearsal$/).answer(clean);
    const asked = newest("PUT", /missions\/flight$/);
    expect(asked.body).toEqual({ waypoints: draft() });
    expect(document.querySelector(".map-plan-state")?.textContent).toContain("distinto del de la placa");
    await asked.answer({ plan: "flight", waypoints: draft() });
    expect(document.querySelector(".map-plan-state")?.textContent).toContain("igual que en la placa");
  });

  test("that the board flies is sent only after a question, and the board goes on where it was", async () => {
    await downloaded();
    station.send({ fms_plan: { waypoint: 2 } });
    await chooseWaypoint(0);
    button("Al este").focus();
    await user.keyboard("{ArrowRight}");
    await user.click(button("Enviar"));
    expect(station.asked.filter(({ method }) => method !== "GET")).toEqual([]);
    await user.click(button("Enviar y seguir al 3"));
    await newest("POST", /missions\/rehearsal$/).answer(clean);
    await newest("PUT", /missions\/flight$/).answer({ plan: "flight", waypoints: draft() });
    expect(newest("POST", /go_to_waypoint$/).body).toEqual({ value: { plan: 0, index: 2 } });
  });

  test("with an error is not sent, and says which", async () => {
    open();
    act(() =>
      editPlan(station.page.parts.get(MISSIONS).plans, "flight", [
        { ...(plan[0] as Waypoint), altitude_ft: 70_000 },
      ]),
    );
    station.show();
    expect(button("Enviar").getAttribute("aria-disabled")).toBe("true");
    await user.click(button(/70000 ft/));
    expect(station.page.parts.get(SELECTION).getState().thing).toEqual({
      kind: "waypoint",
      plan: "flight",
      row: 0,
    });
  });

  test("is not offered to a board that takes none, which is told why", () => {
    open(
      aStatus({
        board: {
          ...aStatus().board,
          mode: "legacy",
          features: { acknowledgements: false, store: false, sources: false, missions: false },
        },
      }),
    );
    expect(button("Enviar").getAttribute("aria-disabled")).toBe("true");
    expect(document.body.textContent).toContain("Esta placa no transfiere planes");
  });
});

test("the route that the board says it flies is shown without asking for it, and edits begin from it", async () => {
  open();
  station.send({ board_status: { hil_plan_name: 0 }, fms_hil_plan: { waypoint: 3 } });
  const state = document.querySelector(".map-plan-state")?.textContent;
  expect(state).toContain("8 waypoints");
  expect(state).toContain("vuela al waypoint 4");
  expect(state).toContain("Al acabar vuelve al primero");
  expect(station.asked.filter(({ path }) => path.includes("missions"))).toEqual([]);
  await chooseWaypoint(7);
  button("Más alto").focus();
  await user.keyboard("{PageDown}");
  expect(station.page.parts.get(MISSIONS).plans.getState().hil.draft.present[7]?.altitude_ft).toBe(240);
  await user.click(button("Deshacer"));
  expect(document.querySelector(".map-plan-state")?.textContent).toContain("igual que en la placa");
});

test("an aircraft's values are in its card, stale when they are old; one never heard says so", async () => {
  open();
  expect(button("Avión real").getAttribute("aria-disabled")).toBe("true");
  station.send({ simulator: { latitude_deg: 27.9, longitude_deg: -15.4, altitude_msl_ft: 1000 } });
  await user.click(button("Avión HIL"));
  station.show();
  const card = screen.getByRole("region", { name: "Avión HIL" });
  expect(card.textContent).toContain("27.900000");
  // Where it flies to and where its nose points are two angles.
  expect(card.textContent).toContain("Rumbo sobre el suelo");
  expect(card.textContent).toContain("Heading");
  const latitude = within(card).getByText("Latitud").closest(".ui-readout");
  expect(latitude?.getAttribute("data-state")).toBe("live");
  station.pass(5000);
  expect(latitude?.getAttribute("data-state")).toBe("stale");
});

test("the turns of the line law are said where it is known to fly, and not of another law", async () => {
  await downloaded();
  const gain = {
    ...{ row: 0, name: "guidance_law", group: "guidance", type: "enum", unit: "1", minimum: 0, maximum: 1 },
    ...{ step: 1, default: 0, choices: ["deployed", "line"], needs_restart: false, doc: "" },
  } as const;
  const bank = { ...gain, row: 1, name: "line_bank_limit", type: "f32", choices: [], maximum: 60 } as const;
  const held = (value: number) => ({ value, loaded: value, state: "loaded" as const, heard_s: 1 });
  const table = {
    state: "known",
    blocks_read: 2,
    block_count: 2,
    gains: [gain, bank],
    topics: [],
    left_out: [],
  } as const;
  const say = /La ley de línea vira con 40° de alabeo/;
  const tell = (data: unknown): void => station.deliver({ type: "event", event: "own_gains", t_s: 1, data });
  tell({ table, values: { guidance_law: held(0), line_bank_limit: held(40) } });
  expect(screen.queryByText(say)).toBeNull();
  tell({ table: null, values: { guidance_law: held(1) } });
  expect(screen.getByText(say)).toBeDefined();
});
