import { screen } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { expect, test } from "vitest";
import { aStatus, heldBy } from "../../test/aStatus";
import { Station } from "../../test/station";
import { WORDS } from "../../ui/test/testWords";
import { WordsProvider } from "../../ui/words";
import { SourceBanner } from "./SourceBanner";

const user = userEvent.setup();
const flying = { autopilot_hil: true, autotrim_hil: true, source_joystick: true };
const rc = { autopilot_hil: false, autotrim_hil: false, source_joystick: false };
const back = { ...rc, source_joystick: true };

/** With the joystick, with RC, and with the joystick again. */
function returned(): Station {
  const station = new Station(
    <WordsProvider words={WORDS}>
      <SourceBanner />
    </WordsProvider>,
  );
  station.greet();
  for (const heartbeat of [flying, rc, back]) {
    station.send({ heartbeat });
  }
  return station;
}

test("after RC it is said what it left off, with commands that switch it on again", async () => {
  const station = returned();
  expect(screen.getByRole("status", { name: "Tras RC" }).textContent).toContain(
    "Al volver de RC siguen quitados: Autopilot, Autotrim.",
  );
  await user.click(screen.getByRole("button", { name: "Autopilot On" }));
  expect(station.asked.map(({ method, path }) => `${method} ${path}`)).toEqual([
    "POST /api/v1/commands/autopilot_on",
  ]);
  await station.asked[0]?.answer({ state: "confirmed", by: "heartbeat", ms: 80, reason: null });
  station.send({ heartbeat: { ...back, autopilot_hil: true } });
  expect(screen.getByRole("status", { name: "Tras RC" }).textContent).toContain("siguen quitados: Autotrim.");
  station.send({ heartbeat: flying });
  expect(screen.getByRole("status", { name: "Tras RC" }).textContent).toBe("");
});

test("a command without proof leaves the notice where it is", async () => {
  const station = returned();
  await user.click(screen.getByRole("button", { name: "Autotrim On" }));
  await station.asked[0]?.answer({ state: "timed_out", by: "heartbeat", ms: 1200, reason: null });
  station.send({ heartbeat: back });
  expect(screen.getByRole("status", { name: "Tras RC" }).textContent).toContain("Autopilot, Autotrim");
});

test("whoever wants them off says so, and the notice goes", async () => {
  const station = returned();
  await user.click(screen.getByRole("button", { name: "Dejarlos quitados" }));
  station.send({ heartbeat: back });
  expect(screen.getByRole("status", { name: "Tras RC" }).textContent).toBe("");
  expect(station.asked).toEqual([]);
});

test("a viewer is told, and cannot switch anything", async () => {
  const station = returned();
  station.status(aStatus({ control: heldBy("c2", "Ana") }));
  await user.click(screen.getByRole("button", { name: "Autopilot On" }));
  expect(station.asked).toEqual([]);
});

test("another board has nothing to do with what the last one did", () => {
  const station = new Station(
    <WordsProvider words={WORDS}>
      <SourceBanner />
    </WordsProvider>,
  );
  station.greet();
  station.send({ heartbeat: flying });
  station.send({ heartbeat: rc });
  const { board } = aStatus();
  station.status(aStatus({ board: { ...board, url: "tcp://other:1" } }));
  station.send({ heartbeat: back });
  expect(screen.getByRole("status", { name: "Tras RC" }).textContent).toBe("");
});
