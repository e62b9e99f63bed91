import { act, screen } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { expect, test } from "vitest";
import type { Waypoint } from "../lib/plan";
import { type FakeRequest, Station } from "../test/station";
import { WORDS } from "../ui/test/testWords";
import { WordsProvider } from "../ui/words";
import { editPlan, MISSIONS } from "./planDrafts";
import { RehearsalPanel } from "./RehearsalPanel";

const user = userEvent.setup();
const first: Waypoint = { latitude_deg: 27.9515, longitude_deg: -15.3741, altitude_ft: 700, speed_kt: 55 };
const drawn = [first, { ...first, latitude_deg: 27.9603 }, { ...first, latitude_deg: 27.9739 }];

/** The part with a drawn plan, and the rows that were gone to. */
function open(): { station: Station; gone: number[] } {
  const gone: number[] = [];
  const station = new Station(
    <WordsProvider words={WORDS}>
      <RehearsalPanel plan="flight" onGo={(row) => gone.push(row)} />
    </WordsProvider>,
  );
  station.greet();
  act(() => editPlan(station.page.parts.get(MISSIONS).plans, "flight", drawn));
  return { station, gone };
}

async function fly(station: Station): Promise<FakeRequest> {
  await user.click(screen.getByRole("button", { name: "Volarlo en el modelo" }));
  const asked = station.asked.at(-1);
  if (asked === undefined) throw new Error("the page asked nothing");
  return asked;
}

test("what a flight finds is listed with its legs, until the plan is edited", async () => {
  const { station, gone } = open();
  const asked = await fly(station);
  expect(asked).toMatchObject({ path: "/api/v1/missions/rehearsal", body: { waypoints: drawn, first: 0 } });
  const findings = [{ code: "short_leg", row: 1, params: { distance_m: 120, radius_m: 200 } }];
  await asked.answer({
    time_s: 95,
    last: 2,
    ground: "part",
    heights: [],
    fence: false,
    battery: true,
    findings,
  });
  const words = screen.getByText(/^Volado en el modelo/).textContent;
  expect(words).toContain(
    "1:35 min hasta el waypoint 3. Sin juzgar: parte del terreno (no se sabe su altura), la valla (no hay).",
  );
  expect(words).not.toContain("No se encontró nada.");
  await user.click(screen.getByRole("button", { name: /Tramo hasta el 2: demasiado corto/ }));
  expect(gone).toEqual([1]);
  act(() => editPlan(station.page.parts.get(MISSIONS).plans, "flight", drawn.slice(1)));
  expect(screen.queryByText(/^Volado en el modelo/)).toBeNull();
});

test("a flight that finds nothing says so, with how it was flown", async () => {
  const { station } = open();
  const asked = await fly(station);
  const heights = [
    { name: "Gando", datum: "ellipsoidal", geoid_m: 43.9 },
    { name: "isla", datum: null, geoid_m: 42.1 },
  ];
  await asked.answer({
    time_s: 95,
    last: 2,
    ground: "whole",
    heights,
    fence: true,
    battery: true,
    findings: [],
  });
  const words = screen.getByText(/^Volado en el modelo.*No se encontró nada\.$/).textContent;
  expect(words).toContain(
    "las alturas de Gando, que cuentan desde el elipsoide: EGM96 las ha convertido en 144 ft",
  );
  expect(screen.getByText(/las alturas de isla.*pueden estar mal en 138 ft/)).toBeDefined();
});

test("a plan that was not flown says why, and nothing that looks like a result", async () => {
  const { station } = open();
  const asked = await fly(station);
  await asked.answer({ code: "rehearsal_failed", detail: "No.", params: {} }, 409);
  expect(screen.getByText("El plan no se voló en el modelo: falló su programa.")).toBeDefined();
  expect(screen.queryByText(/No se encontró nada/)).toBeNull();
});
