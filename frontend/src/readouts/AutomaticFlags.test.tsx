import { screen } from "@testing-library/react";
import { beforeEach, expect, test } from "vitest";
import { Station } from "../test/station";
import { WORDS } from "../ui/test/testWords";
import { WordsProvider } from "../ui/words";
import { AutomaticFlags, OtherAutopilot } from "./AutomaticFlags";
import { FmsReadouts } from "./FmsReadouts";

let station: Station;

beforeEach(() => {
  station = new Station(
    <WordsProvider words={WORDS}>
      <AutomaticFlags of="hil" />
      <OtherAutopilot />
      <FmsReadouts topic="fms_plan" columns={3} />
    </WordsProvider>,
  );
  station.greet();
});

test("why the autopilot is on in one place and off in another is said while it is so, and only by live news", () => {
  station.send({ heartbeat: { autopilot: false, autopilot_hil: true } });
  expect(screen.getByText("Autopilot HIL").parentElement?.textContent).toContain("on");
  expect(screen.getByText(/autopilot del avión real.*HIL es otro, y está en On/)).toBeTruthy();
  station.send({ heartbeat: { autopilot: true, autopilot_hil: true } });
  expect(screen.queryByText(/autopilot del avión real/)).toBeNull();
  station.send({ heartbeat: { autopilot: true, autopilot_hil: false } });
  expect(screen.getByText(/HIL es otro, y está en Off/)).toBeTruthy();
  station.pass(20_000);
  expect(screen.queryByText(/autopilot del avión real/)).toBeNull();
});

test("a board without a plan says so instead of dashes alone", () => {
  expect(screen.queryByText(/No hay ningún plan/)).toBeNull();
  station.send({ fms_plan: { waypoint: null, bearing_deg: null, altitude_ft: null } });
  expect(screen.getByText(/No hay ningún plan en la placa para el vuelo real/)).toBeTruthy();
  station.send({ fms_plan: { waypoint: 0, altitude_ft: 300 } });
  expect(screen.queryByText(/No hay ningún plan/)).toBeNull();
});
