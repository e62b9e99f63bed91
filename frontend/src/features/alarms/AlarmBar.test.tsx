import { act, screen, within } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { describe, expect, test } from "vitest";
import type { Waypoint } from "../../lib/plan";
import { boardHas, MISSIONS } from "../../missions/planDrafts";
import type { Status } from "../../protocol/status";
import { aStatus } from "../../test/aStatus";
import { Station } from "../../test/station";
import { WORDS } from "../../ui/test/testWords";
import { WordsProvider } from "../../ui/words";
import { AlarmBar } from "./AlarmBar";
import { ALARM_LOG } from "./alarmLog";

const user = userEvent.setup();
const LOST = {
  id: "heartbeat_lost",
  level: "critical",
  since_s: 1_699_999_990,
  text: "Lost.",
  params: { target: "pty" },
  acknowledged: false,
} as const;
const LOW = { ...LOST, id: "battery_low", level: "warning", params: { battery_v: 9.8 } } as const;
const SLOW = { ...LOW, id: "cpu_high", params: { percent: 97 } } as const;

function opened(): Station {
  const station = new Station(
    <WordsProvider words={WORDS}>
      <AlarmBar />
    </WordsProvider>,
  );
  station.greet();
  return station;
}

function raise(station: Station, ...alarms: Status["alarms"]): void {
  station.status(aStatus({ alarms, server_time_s: 1_700_000_000 }));
}

function strip(): HTMLElement {
  return screen.getByRole("region", { name: "Alarmas" });
}

describe("an alarm that ends before anybody acknowledged it", () => {
  test("leaves its name and the time of its end, until that is acknowledged", async () => {
    const station = opened();
    raise(station, LOST);
    raise(station);
    const clock = new Date(1_700_000_000_000).toLocaleTimeString("es", { hour12: false });
    const trace = within(strip()).getByRole("listitem");
    expect(trace.textContent).toContain("latido perdido");
    expect(trace.textContent).toContain(clock);
    expect(strip().textContent).toContain("Terminada sin reconocer");
    await user.click(within(trace).getByRole("button", { name: "Reconocer que terminó: latido perdido" }));
    expect(strip().textContent).toBe("");
    expect(station.asked).toEqual([]);
  });

  test("leaves no such trace when it was acknowledged, nor while it is raised again", () => {
    const station = opened();
    raise(station, { ...LOST, acknowledged: true }, LOW);
    raise(station);
    expect(within(strip()).getAllByRole("listitem")).toHaveLength(1);
    raise(station, LOW);
    expect(within(strip()).queryByRole("listitem")).toBeNull();
  });

  test("is counted beside alarms that take all the room, and goes with the rest", async () => {
    const station = opened();
    raise(station, LOST, LOW, SLOW);
    raise(station, LOW, SLOW);
    const more = within(strip()).getByRole("button", {
      name: "Ver la lista: 1 alarma terminada sin reconocer",
    });
    await user.click(more);
    expect(station.page.settings.getState().choices["tab"]).toBe("alarms");
    await user.click(within(strip()).getByRole("button", { name: "Reconocer todas" }));
    expect(within(strip()).queryByRole("button", { name: /terminada/ })).toBeNull();
  });

  test("leaves its trace also when the page did not hear the gateway meanwhile", () => {
    const station = opened();
    raise(station, LOST);
    station.breakOff();
    station.pass(300);
    raise(station);
    expect(
      within(strip())
        .getAllByRole("listitem")
        .map(({ textContent }) => textContent),
    ).toEqual([expect.stringContaining("latido perdido"), expect.stringContaining("estación perdida")]);
  });
});

describe("a board that started anew", () => {
  const data = { silent_s: 3.4, parameters: ["k_roll", "k_pitch"], plans: ["hil"] };
  const waypoint: Waypoint = { latitude_deg: 27.9, longitude_deg: -15.3, altitude_ft: 700, speed_kt: 55 };

  function restarted(): Station {
    const station = opened();
    act(() => boardHas(station.page.parts.get(MISSIONS).plans, "hil", [waypoint]));
    station.deliver({ type: "event", event: "board_restarted", t_s: 1_699_999_998, data });
    return station;
  }

  test("is told as an alarm, with the gains and plans that are lost", () => {
    restarted();
    expect(within(strip()).getByRole("alert").textContent).toContain(
      "La placa se ha reiniciado: Autopilot y Autotrim están quitados. Se pierden los parámetros k_roll, k_pitch y el plan HIL.",
    );
  });

  test("has no plans that are known here", () => {
    const station = restarted();
    expect(station.page.parts.get(MISSIONS).plans.getState().hil.board).toBeNull();
  });

  test("stays told, and is heard, until somebody has seen it", async () => {
    const station = restarted();
    for (let round = 0; round < 20; round += 1) {
      station.pass(400);
      station.status(aStatus());
    }
    expect(station.sounder.played.length).toBeGreaterThan(1);
    await user.click(within(strip()).getByRole("button", { name: /^Reconocer: La placa se ha reiniciado/ }));
    expect(strip().textContent).toBe("");
    expect(station.asked).toEqual([]);
    expect(station.page.parts.get(ALARM_LOG).store.getState().ownPast).toMatchObject([
      { id: "board_restarted", acknowledged: true },
    ]);
  });

  test("that had nothing to lose is told all the same", () => {
    const station = opened();
    const nothing = { silent_s: null, parameters: [], plans: [] };
    station.deliver({ type: "event", event: "board_restarted", t_s: 1_699_999_998, data: nothing });
    expect(within(strip()).getByRole("alert").textContent).toContain("La placa se ha reiniciado");
  });
});
