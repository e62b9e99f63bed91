import { act, screen } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { expect, test } from "vitest";
import { boardHas, editPlan, MISSIONS } from "../../../missions/planDrafts";
import { Station } from "../../../test/station";
import { WORDS } from "../../../ui/test/testWords";
import { WordsProvider } from "../../../ui/words";
import { MAP_TOOL } from "../tools/mapTool";
import { FlyHere } from "./FlyHere";

const user = userEvent.setup();
const PLACE = { latitude_deg: 27.95, longitude_deg: -15.4 };

test("nobody is sent at the old altitude while it is not clear which one was typed", async () => {
  const station = new Station(
    <WordsProvider words={WORDS}>
      <FlyHere />
    </WordsProvider>,
  );
  station.greet();
  const { parts } = station.page;
  act(() => {
    boardHas(parts.get(MISSIONS).plans, "flight", [{ ...PLACE, altitude_ft: 700, speed_kt: 55 }]);
    parts.get(MAP_TOOL).setState({ flyTo: { ...PLACE, latitude_deg: 27.96 } });
  });
  station.send({ fms_plan: { waypoint: 0 } });
  const field = screen.getByRole("textbox");
  const go = (): Promise<void> => user.click(screen.getByRole("button", { name: "Ir y esperar allí" }));
  const sent = () => station.asked.filter(({ method }) => method === "PUT");
  await user.clear(field);
  await user.type(field, "1.200");
  await go();
  expect(sent()).toEqual([]);
  expect(screen.getByRole("dialog").textContent).toContain("w-open");
  await user.click(screen.getByRole("button", { name: "1200 ft" }));
  await go();
  expect(sent()[0]?.body).toMatchObject({ waypoints: [{ altitude_ft: 700 }, { altitude_ft: 1200 }] });
});

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
