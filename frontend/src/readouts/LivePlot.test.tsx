import { act, cleanup, screen } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { useState } from "react";
import { beforeEach, expect, test } from "vitest";
import { aStatus } from "../test/aStatus";
import { type FakeRequest, Station } from "../test/station";
import { WORDS } from "../ui/test/testWords";
import { WordsProvider } from "../ui/words";
import { LivePlot, type PlotEvent } from "./LivePlot";
import type { Signal } from "./signals";

const ROLL: Signal = { topic: "ahrs", field: "roll_deg", label: "Roll", unit: "°" };
const SPEED: Signal = { topic: "simulator", field: "indicated_airspeed_kt", label: "Vind", unit: "kt" };
const DOUBLE: Signal = { row: 17, index: 0, label: "Doble", scale: (value) => 2 * value };

/** Where the clock of the tests begins. */
const NOW_S = 1_700_000_000;

let station: Station;
let show: (signals: readonly Signal[]) => void;
let happen: (events: readonly PlotEvent[]) => void;

function Bench() {
  const [signals, setSignals] = useState<readonly Signal[]>([ROLL]);
  const [events, setEvents] = useState<readonly PlotEvent[]>([]);
  show = (next) => act(() => setSignals(next));
  happen = (next) => act(() => setEvents(next));
  return (
    <WordsProvider words={WORDS}>
      <LivePlot signals={signals} window_s={2} label="Alabeo" events={events} />
    </WordsProvider>
  );
}

beforeEach(() => {
  station = new Station(<Bench />);
  station.greet();
});

function picture(): HTMLElement {
  return screen.getByRole("figure", { name: "Alabeo" });
}

/** The plot's description, which changes once a second. */
function words(): string {
  return picture().querySelector("p")?.textContent ?? "";
}

function key(): string {
  return screen.getByRole("list").textContent ?? "";
}

test("it says in words what it shows: the newest value, the least and the greatest of the window", () => {
  for (const roll_deg of [10, -4.5, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2]) {
    station.send({ ahrs: { roll_deg } });
  }
  expect(words()).toBe("Roll: 2.0000 °, entre -4.5000 y 10.000.");
  expect(key()).toBe("Roll2.0000°");
});

test("what is not live has no value, and what left the window is forgotten", () => {
  station.send({ ahrs: { roll_deg: 10 } });
  station.pass(900);
  expect(key()).toBe("Roll–°");
  station.pass(3000);
  expect(words()).toBe("Roll: sin datos.");
});

test("a value of a simulator's row is drawn as it is scaled", () => {
  show([DOUBLE]);
  station.rows({ 17: [3, null, null, null, null, null, null, null] });
  expect(key()).toBe("Doble6.0000");
});

test("signals that stay keep their past when others come", () => {
  station.send({ ahrs: { roll_deg: 10 } });
  show([SPEED, ROLL]);
  station.send({ ahrs: { roll_deg: 3 }, simulator: { indicated_airspeed_kt: 55 } });
  for (let tenth = 0; tenth < 11; tenth += 1) {
    station.send({ ahrs: { roll_deg: 3 }, simulator: { indicated_airspeed_kt: 55 } });
  }
  expect(words()).toBe("Vind: 55.000 kt, entre 55.000 y 55.000. Roll: 3.0000 °, entre 3.0000 y 10.000.");
});

test("a held picture shows what was, and goes on with what is", async () => {
  const user = userEvent.setup();
  station.send({ ahrs: { roll_deg: 10 } });
  await user.click(screen.getByRole("button", { name: "Pausa" }));
  station.send({ ahrs: { roll_deg: 20 } });
  expect(key()).toBe("Roll10.000°");
  expect(screen.getByRole("button", { name: "Pausa" }).getAttribute("aria-pressed")).toBe("true");
  await user.click(screen.getByRole("button", { name: "Pausa" }));
  station.send({ ahrs: { roll_deg: 21 } });
  expect(key()).toBe("Roll21.000°");
});

test("the drawing is fetched when it is needed, and stands on a canvas", async () => {
  await expect.poll(() => picture().querySelector("canvas")).not.toBeNull();
  station.send({ ahrs: { roll_deg: 12 } });
  show([ROLL, SPEED]);
  station.send({ ahrs: { roll_deg: 12 } });
  expect(screen.queryByRole("alert")).toBeNull();
});

test("what happened is said with the time since, until it leaves the picture", () => {
  happen([{ key: "0", label: "k_roll 2 → 3" }]);
  for (let tenth = 0; tenth < 12; tenth += 1) {
    station.send({ ahrs: { roll_deg: 3 } });
  }
  expect(words()).toMatch(/k_roll 2 → 3, hace [01]\.\d s\.$/);
  station.pass(3000);
  expect(words()).not.toContain("k_roll");
});

test("it begins with what the station recorded before it was opened", async () => {
  const name = "20261126T093243Z";
  cleanup();
  station = new Station(
    <WordsProvider words={WORDS}>
      <LivePlot signals={[ROLL, SPEED]} window_s={30} label="Alabeo" fromRecording />
    </WordsProvider>,
  );
  const status = aStatus();
  station.greet({ ...status, recording: { ...status.recording, file: `data/recordings/${name}.mcap` } });
  station.send({ ahrs: { roll_deg: 3 } });
  await asked(/\/topics$/).answer({
    topics: [
      {
        ...{ name: "ahrs", first_s: 0, last_s: 9, count: 9 },
        fields: [{ name: "roll_deg", unit: "deg", kind: "number" }],
      },
    ],
  });
  const question = asked(/\/signals\?/);
  expect(question.path).toMatch(new RegExp(`/flights/${name}/signals\\?names=ahrs.roll_deg&`));
  const before_s = [-20, -10, -9.5];
  await question.answer({
    starts_s: NOW_S,
    from_s: 0,
    to_s: 1,
    signals: [
      {
        ...{ name: "ahrs.roll_deg", unit: "deg", count: 3, mean: null },
        ...{ at_s: before_s, min: [1, -25, 2], max: [1, -25, 2] },
      },
    ],
  });
  for (let tenth = 0; tenth < 11; tenth += 1) {
    station.send({ ahrs: { roll_deg: 3 } });
  }
  expect(words()).toBe("Roll: 3.0000 °, entre -25.000 y 3.0000. Vind: sin datos.");
});

function asked(path: RegExp): FakeRequest {
  const found = station.asked.find((question) => path.test(question.path));
  if (found === undefined) {
    throw new Error(`nothing was asked at ${path}`);
  }
  return found;
}
