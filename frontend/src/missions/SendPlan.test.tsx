import { act, screen } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { expect, test } from "vitest";
import type { Waypoint } from "../lib/plan";
import { type FakeRequest, Station } from "../test/station";
import { WORDS } from "../ui/test/testWords";
import { WordsProvider } from "../ui/words";
import { boardHas, editPlan, MISSIONS, noteHazards, usePlans } from "./planDrafts";
import { SendPlan } from "./SendPlan";

const user = userEvent.setup();
const first: Waypoint = { latitude_deg: 27.9515, longitude_deg: -15.3741, altitude_ft: 700, speed_kt: 55 };
const second = { ...first, latitude_deg: 27.9603 };
const third = { ...first, latitude_deg: 27.9739 };
const fresh = { ...first, latitude_deg: 27.9555 };

function Send() {
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

const sent = { plan: "flight", waypoints: [first, fresh, second, third] };

test("a board that is about to fly to the first waypoint gets the plan without a question", async () => {
  const station = edited();
  station.send({ fms_plan: { waypoint: 0 }, heartbeat: { autopilot: true } });
  await press("send");
  expect(newest(station)).toMatchObject({ method: "PUT", path: "/api/v1/missions/flight" });
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
  await newest(station).answer(sent);
  expect(station.asked).toHaveLength(1);
});

test("a question keeps its answers when the stream that it was asked by ends under the finger", async () => {
  const station = edited();
  station.send({ fms_plan: { waypoint: 1 } });
  await press("send");
  station.pass(60_000);
  expect(screen.getByRole("alertdialog").textContent).toContain("La placa vuela al waypoint 2");
  await press("Enviar y seguir al 3");
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

test("a board that shall go on is told so, to the same waypoint, once it has the plan", async () => {
  const station = edited();
  station.send({ fms_plan: { waypoint: 1 } });
  await press("send");
  await press("Enviar y seguir al 3");
  expect(station.asked).toHaveLength(1);
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
  await newest(station).answer({ code: "mission_refused", detail: "No.", params: {} }, 502);
  expect(station.asked).toHaveLength(1);
});

test("an autopilot that flies nobody knows where to is asked for as well, and can only start again", async () => {
  const station = edited();
  station.send({ heartbeat: { autopilot: true } });
  await press("send");
  expect(screen.getByRole("alertdialog").textContent).toContain("no se sabe a qué waypoint");
  expect(screen.queryByRole("button", { name: /seguir al/ })).toBeNull();
  await press("Enviar y empezar por el 1");
  expect(newest(station).method).toBe("PUT");
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
  expect(screen.getByRole("alertdialog").textContent).toContain(
    "Waypoint 2: el tramo hasta él sale de la valla.",
  );
  await press("Cancelar");
  expect(station.asked).toEqual([]);
  await press("send");
  await press("Enviar de todos modos");
  expect(newest(station).method).toBe("PUT");
  // Hazards of other waypoints are not those of these.
  act(() => editPlan(plans, "flight", of.slice(0, 1)));
  await press("send");
  expect(screen.queryByRole("alertdialog")).toBeNull();
});
