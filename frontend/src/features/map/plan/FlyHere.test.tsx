import { act, screen } from "@testing-library/react";
import { expect, test } from "vitest";
import { boardHas, editPlan, MISSIONS } from "../../../missions/planDrafts";
import { Station } from "../../../test/station";
import { WORDS } from "../../../ui/test/testWords";
import { WordsProvider } from "../../../ui/words";
import { MAP_TOOL } from "../tools/mapTool";
import { FlyHere } from "./FlyHere";

const PLACE = { latitude_deg: 27.95, longitude_deg: -15.4 };

test("a question where to fly stays with its aircraft when the other one's plan comes", () => {
  const station = new Station(
    <WordsProvider words={WORDS}>
      <FlyHere />
    </WordsProvider>,
  );
  station.greet();
  const { parts } = station.page;
  act(() => parts.get(MAP_TOOL).setState({ flyTo: PLACE }));
  const asked = screen.getByRole("dialog").textContent;
  expect(asked).toContain("Plan HIL");
  const waypoints = [{ ...PLACE, altitude_ft: 700, speed_kt: 55 }];
  act(() => {
    boardHas(parts.get(MISSIONS).plans, "flight", waypoints);
    editPlan(parts.get(MISSIONS).plans, "flight", waypoints);
  });
  expect(screen.getByRole("dialog").textContent).toBe(asked);
});
