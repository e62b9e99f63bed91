import { screen, within } from "@testing-library/react";
import { expect, test } from "vitest";
import { aStatus } from "../../test/aStatus";
import { Station } from "../../test/station";
import { WORDS } from "../../ui/test/testWords";
import { WordsProvider } from "../../ui/words";
import { ControlsPanel } from "./ControlsPanel";
import { LiveControlPath } from "./LiveControlPath";

test("controls and signal's way name a gamepad that is the stick, and while it is lost no position is shown", () => {
  const station = new Station(
    <WordsProvider words={WORDS}>
      <ControlsPanel />
      <LiveControlPath />
    </WordsProvider>,
  );
  const { hil } = aStatus();
  const stick = { source: "gamepad", client: "c2", name: "Torre", gamepad: "Test Pad", samples: {} } as const;
  station.greet(aStatus({ hil: { ...hil, stick: { ...stick, state: "live" } } }));
  station.send({
    heartbeat: { source_joystick: true },
    xplane_info: { elevator: 0, aileron: 0, rudder: 0, throttle: 0.4 },
  });
  const controls = screen.getByRole("region", { name: "Controles" });
  const way = screen.getByRole("img", { name: "Camino de la señal de control" });
  expect(controls.textContent).toContain("Mando");
  expect(controls.textContent).toContain("0.40");
  expect(within(way).getByText("Mando")).toBeTruthy();

  // The board now gets a centred stick, which must be shown as nobody's position.
  station.status(aStatus({ hil: { ...hil, stick: { ...stick, state: "lost" } } }));
  expect(controls.textContent).toContain("Sin mando");
  expect(controls.textContent).not.toContain("0.40");
  expect(within(way).getByText("Sin mando")).toBeTruthy();
});
