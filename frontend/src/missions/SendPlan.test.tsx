import { act, screen, within } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { expect, test } from "vitest";
import type { Waypoint } from "../lib/plan";
import { useSettings } from "../store/hooks";
import { choose } from "../store/settings";
import { type FakeRequest, Station } from "../test/station";
import { WORDS } from "../ui/test/testWords";
import { WordsProvider } from "../ui/words";
import { boardHas, editPlan, MISSIONS, noteHazards, usePlans } from "./planDrafts";
import { ENDURANCE_CHOICE } from "./rehearsal";
import { SendPlan } from "./SendPlan";
import { WIND_CHOICES } from "./useWind";

const user = userEvent.setup();
const first: Waypoint = { latitude_deg: 27.9515, longitude_deg: -15.3741, altitude_ft: 700, speed_kt: 55 };
const second = { ...first, latitude_deg: 27.9603 };
const third = { ...first, latitude_deg: 27.9739 };
const fresh = { ...first, latitude_deg: 27.9555 };

function Send() {
  const isHidden = useSettings(({ choices }) => choices["test.hidden"] === "yes");
  return isHidden ? null : <Shown />;
}

function Shown() {
  const onBoard = usePlans((plans) => plans.flight.board);
  return (
    <SendPlan plan="flight" onBoard={onBoard} disabledReason={undefined}>
      send
    </SendPlan>
  );
}

/** A board with three waypoints, and a draft with one more behind the first. */
function edited(): Station {
  const station = new Station(
    <WordsProvider words={WORDS}>
      <Send />
    </WordsProvider>,
  );
  station.greet();
  const { plans } = station.page.parts.get(MISSIONS);
  act(() => {
    boardHas(plans, "flight", [first, second, third]);
    editPlan(plans, "flight", [first, fresh, second, third]);
  });
  return station;
}

async function press(name: string | RegExp): Promise<void> {
  await user.click(screen.getByRole("button", { name }));
}

function newest(station: Station): FakeRequest {
  const asked = station.asked.at(-1);
  if (asked === undefined) throw new Error("the page asked nothing");
  return asked;
}

/** The model flew the plan, and found this. */
async function flown(
  station: Station,
  findings: readonly object[] = [],
  heights: readonly object[] = [],
): Promise<void> {
  const asked = newest(station);
  expect(asked).toMatchObject({ method: "POST", path: "/api/v1/missions/rehearsal" });
  await asked.answer({
    time_s: 605,
    last: 3,
    ground: "none",
    heights,
    fence: true,
    battery: false,
    findings,
  });
}

const sent = { plan: "flight", waypoints: [first, fresh, second, third] };

test("a board that is about to fly to the first waypoint gets the plan without a question", async () => {
  const station = edited();
  station.send({ fms_plan: { waypoint: 0 }, heartbeat: { autopilot: true } });
  await press("send");
  await flown(station);
  expect(newest(station)).toMatchObject({ method: "PUT", path: "/api/v1/missions/flight" });
});

test("a plan judged by heights of which nobody said what they count from is sent only after a question", async () => {
  const station = edited();
  station.send({ fms_plan: { waypoint: 0 }, heartbeat: { autopilot: true } });
  await press("send");
  await flown(station, [], [{ name: "isla", datum: null, geoid_m: 42.1 }]);
  expect(newest(station).path).toBe("/api/v1/missions/rehearsal");
  expect(screen.getByRole("alertdialog").textContent).toContain("pueden estar mal en 138 ft");
});

test("a board that flies the plan gets another only after a question, and starts it again if that is chosen", async () => {
  const station = edited();
  station.send({ fms_plan: { waypoint: 1 } });
  await press("send");
  expect(screen.getByRole("alertdialog").textContent).toContain("La placa vuela al waypoint 2");
  await press("Cancelar");
  expect(station.asked).toEqual([]);
  await press("send");
  await press("Enviar y empezar por el 1");
  await flown(station);
  await newest(station).answer(sent);
  expect(station.asked).toHaveLength(2);
});

test("a question keeps its answers when the stream that it was asked by ends under the finger", async () => {
  const station = edited();
  station.send({ fms_plan: { waypoint: 1 } });
  await press("send");
  station.pass(60_000);
  expect(screen.getByRole("alertdialog").textContent).toContain("La placa vuela al waypoint 2");
  await press("Enviar y seguir al 3");
  await flown(station);
  await newest(station).answer(sent);
  expect(newest(station).body).toEqual({ value: { plan: 0, index: 2 } });
});

test("a question follows the board to its next waypoint", async () => {
  const station = edited();
  station.send({ fms_plan: { waypoint: 1 } });
  await press("send");
  station.send({ fms_plan: { waypoint: 2 } });
  expect(screen.getByRole("button", { name: "Enviar y seguir al 4" })).toBeDefined();
});

test("a question that did not know where the board flies to offers to go on as soon as that is known", async () => {
  const station = edited();
  station.send({ fms_plan: { waypoint: 1 }, heartbeat: { autopilot: true } });
  station.pass(60_000);
  await press("send");
  const question = screen.getByRole("alertdialog");
  const last = () => within(question).getAllByRole("button").at(-1)?.textContent;
  expect(last()).toBe("Enviar y empezar por el 1");
  station.send({ fms_plan: { waypoint: 1 } });
  expect(question.textContent).toContain("La placa vuela al waypoint 2");
  expect(last()).toBe("Enviar y empezar por el 1");
  await press("Enviar y seguir al 3");
  await flown(station);
  await newest(station).answer(sent);
  expect(newest(station).body).toEqual({ value: { plan: 0, index: 2 } });
});

test("a board that shall go on is told so, to the same waypoint, once it has the plan", async () => {
  const station = edited();
  station.send({ fms_plan: { waypoint: 1 } });
  await press("send");
  await press("Enviar y seguir al 3");
  expect(newest(station).body).toMatchObject({ first: 2 });
  await flown(station);
  await newest(station).answer(sent);
  expect(newest(station)).toMatchObject({
    path: "/api/v1/commands/go_to_waypoint",
    body: { value: { plan: 0, index: 2 } },
  });
  await newest(station).answer({ state: "confirmed", by: "acknowledgement", ms: 20, reason: null });
  expect(station.page.messages.getState().last?.key).toBe("said.confirmedBy");
});

test("without proof that the board goes on it is said that it may have started again", async () => {
  const station = edited();
  station.send({ fms_plan: { waypoint: 1 } });
  await press("send");
  await press("Enviar y seguir al 3");
  await flown(station);
  await newest(station).answer(sent);
  await newest(station).answer({ state: "timed_out", by: "acknowledgement", ms: 500, reason: null });
  expect(station.page.messages.getState().last).toMatchObject({
    level: "error",
    key: "plans.saidNotGone",
    params: { number: 3 },
  });
});

test("a plan that the board refused is followed by no command", async () => {
  const station = edited();
  station.send({ fms_plan: { waypoint: 1 } });
  await press("send");
  await press("Enviar y seguir al 3");
  await flown(station);
  await newest(station).answer({ code: "mission_refused", detail: "No.", params: {} }, 502);
  expect(station.asked).toHaveLength(2);
});

test("an autopilot that flies nobody knows where to is asked for as well, and can only start again", async () => {
  const station = edited();
  station.send({ heartbeat: { autopilot: true } });
  await press("send");
  expect(screen.getByRole("alertdialog").textContent).toContain("no se sabe a qué waypoint");
  expect(screen.queryByRole("button", { name: /seguir al/ })).toBeNull();
  await press("Enviar y empezar por el 1");
  await flown(station);
  expect(newest(station).method).toBe("PUT");
});

test("a plan in which nothing was found is sent at once, and it is said how it was flown and what was not judged", async () => {
  const station = edited();
  await press("send");
  expect(newest(station).body).toEqual({
    waypoints: [first, fresh, second, third],
    first: 0,
    start: null,
    wind: { from_deg: 0, speed_kt: 0 },
    endurance_min: null,
  });
  await flown(station);
  expect(newest(station).method).toBe("PUT");
  const said = station.page.messages.getState().last;
  expect(said?.key).toBe("rehearsal.saidClean");
  expect(said?.params["what"]).toBe(
    "Volado en el modelo desde su primer waypoint, porque no se sabe dónde está el avión, sin viento: 10:05 min hasta el " +
      "waypoint 4. Sin juzgar: el terreno (no se sabe su altura), la batería (di cuánto dura).",
  );
});

test("the plan is flown from where the aircraft is, in the wind and with the battery that were entered", async () => {
  const station = edited();
  choose(station.page.settings, WIND_CHOICES.from, "330");
  choose(station.page.settings, WIND_CHOICES.speed, "20");
  choose(station.page.settings, ENDURANCE_CHOICE, "40");
  station.send({
    gps: {
      latitude_deg: 27.9,
      longitude_deg: -15.4,
      altitude_m: 304.8,
      heading_deg: 90,
      speed_kt: 50,
      fix: 3,
      valid: true,
    },
  });
  await press("send");
  expect(newest(station).body).toMatchObject({
    start: { latitude_deg: 27.9, longitude_deg: -15.4, altitude_ft: 1000, track_deg: 90, speed_kt: 50 },
    wind: { from_deg: 330, speed_kt: 20 },
    endurance_min: 40,
  });
});

test("a place that is not live any more is no start", async () => {
  const station = edited();
  station.send({
    gps: {
      latitude_deg: 27.9,
      longitude_deg: -15.4,
      altitude_m: 304.8,
      heading_deg: 90,
      speed_kt: 50,
      fix: 3,
      valid: true,
    },
  });
  station.pass(60_000);
  await press("send");
  expect(newest(station).body).toMatchObject({ start: null });
});

test("what was found is asked about with its legs, and sent only if that is chosen", async () => {
  const station = edited();
  const findings = [
    { code: "meets_ground", row: 1, params: { below_ft: 120 } },
    { code: "battery_ends", row: 3, params: { lasts_min: 9, takes_min: 10.1 } },
  ];
  await press("send");
  await flown(station, findings);
  const words = screen.getByRole("alertdialog").textContent;
  expect(words).toContain("Tramo hasta el 2: choca con el terreno, 120 ft por debajo de su superficie.");
  expect(words).toContain("Tramo hasta el 4: ahí se acaba la batería; dura 9 min y el plan tarda 10 min.");
  await press("Cancelar");
  expect(station.asked).toHaveLength(1);
  await press("send");
  await flown(station, findings);
  await press("Enviar de todos modos");
  expect(newest(station).method).toBe("PUT");
});

test("a plan that was not flown says why, and can be sent all the same", async () => {
  const station = edited();
  await press("send");
  await newest(station).answer({ code: "rehearsal_late", detail: "Late.", params: { seconds: 9 } }, 409);
  const dialog = screen.getByRole("alertdialog", { name: "¿Enviar un plan que no se voló en el modelo?" });
  expect(dialog.textContent).toContain(
    "El plan no se voló en el modelo: tardaba más de 9 s en este ordenador.",
  );
  await press("Enviar de todos modos");
  expect(newest(station).method).toBe("PUT");
});

test("a press while it is being flown is answered, and a plan that was edited meanwhile is flown again", async () => {
  const station = edited();
  const { plans } = station.page.parts.get(MISSIONS);
  await press("send");
  await press("send");
  expect(station.asked).toHaveLength(1);
  expect(screen.getByRole("button", { name: "send" }).ariaDisabled).toBe("true");
  act(() => editPlan(plans, "flight", [first, second]));
  await flown(station);
  expect(newest(station).body).toMatchObject({ waypoints: [first, second] });
  await flown(station);
  expect(newest(station)).toMatchObject({ method: "PUT", body: { waypoints: [first, second] } });
});

test("a plan with findings whose button has gone is not sent, and that is said", async () => {
  const station = edited();
  await press("send");
  const asked = newest(station);
  act(() => choose(station.page.settings, "test.hidden", "yes"));
  expect(screen.queryByRole("button", { name: "send" })).toBeNull();
  const findings = [{ code: "unreached", row: 1, params: {} }];
  await asked.answer({
    time_s: 605,
    last: 1,
    ground: "whole",
    heights: [],
    fence: true,
    battery: true,
    findings,
  });
  expect(station.asked).toHaveLength(1);
  expect(station.page.messages.getState().last).toMatchObject({
    level: "warning",
    key: "rehearsal.saidNotSent",
  });
});

test("a plan that leaves the fence is sent only after a question, which says where", async () => {
  const station = edited();
  const { plans } = station.page.parts.get(MISSIONS);
  const of = plans.getState().flight.draft.present;
  const issue = {
    level: "warning",
    code: "leaves_fence",
    row: 1,
    field: "latitude_deg",
    params: {},
  } as const;
  act(() => noteHazards(plans, "flight", { of, issues: [issue] }));
  await press("send");
  await flown(station);
  expect(screen.getByRole("alertdialog").textContent).toContain(
    "Waypoint 2: el tramo hasta él sale de la valla.",
  );
  await press("Cancelar");
  expect(station.asked).toHaveLength(1);
  await press("send");
  // A flight that finds the same says it better.
  await flown(station, [{ code: "leaves_fence", row: 1, params: { distance_m: 140 } }]);
  const words = screen.getByRole("alertdialog").textContent;
  expect(words).not.toContain("Waypoint 2: el tramo");
  expect(words).toContain("Tramo hasta el 2: sale 140 m de la valla.");
  await press("Enviar de todos modos");
  expect(newest(station).method).toBe("PUT");
  // Hazards of other waypoints are not those of these.
  act(() => editPlan(plans, "flight", of.slice(0, 1)));
  await press("send");
  await flown(station);
  expect(screen.queryByRole("alertdialog")).toBeNull();
});
