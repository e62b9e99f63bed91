import { act, screen, within } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { describe, expect, test } from "vitest";
import type { Waypoint } from "../../lib/plan";
import { boardHas, MISSIONS } from "../../missions/planDrafts";
import type { Status } from "../../protocol/contract";
import { aStatus, heldBy } from "../../test/aStatus";
import { Station } from "../../test/station";
import { WORDS } from "../../ui/test/testWords";
import { WordsProvider } from "../../ui/words";
import { AlarmBar } from "./AlarmBar";
import { ALARM_LOG } from "./alarmLog";
import { UnseenAlarms } from "./UnseenAlarms";

const user = userEvent.setup();
const LOST = {
  id: "heartbeat_lost",
  level: "critical",
  since_s: 1_699_999_990,
  until_s: null,
  text: "Lost.",
  params: { target: "pty" },
  acknowledged: false,
  count: 1,
} as const;
const LOW = { ...LOST, id: "battery_low", level: "warning", params: { battery_v: 9.8 } } as const;
const ENDED = { ...LOST, until_s: 1_699_999_995 } as const;
const SLOW = { ...LOW, id: "cpu_high", params: { percent: 97 } } as const;

function opened(status: Status = aStatus()): Station {
  const station = new Station(
    <WordsProvider words={WORDS}>
      <AlarmBar />
    </WordsProvider>,
  );
  station.greet(status);
  return station;
}

function raise(station: Station, ...alarms: Status["alarms"]): void {
  station.status(aStatus({ alarms, server_time_s: 1_700_000_000 }));
}

function strip(): HTMLElement {
  return screen.getByRole("region", { name: "Alarmas" });
}

function traces(): readonly (string | null)[] {
  return within(strip())
    .queryAllByRole("listitem")
    .map(({ textContent }) => textContent);
}

describe("an alarm that recovered before anybody acknowledged it", () => {
  const seen = { name: "Reconocer que terminó: latido perdido" };

  test("leaves its name and the time of its end, and calls nobody", () => {
    const station = opened();
    raise(station, ENDED);
    const clock = new Date(ENDED.until_s * 1000).toLocaleTimeString("es", { hour12: false });
    expect(traces()).toEqual([`latido perdido${clock}`]);
    expect(strip().textContent).toContain("Terminada sin reconocer");
    expect(within(strip()).getByRole("alert").textContent).toBe("");
    expect(within(strip()).getByRole("status").textContent).toBe("");
    expect(station.sounder.played).toEqual([]);
  });

  test("is there for a page that was loaded after its end", () => {
    const station = opened(aStatus({ alarms: [ENDED] }));
    expect(traces()).toEqual([expect.stringContaining("latido perdido")]);
    expect(station.sounder.played).toEqual([]);
  });

  test("is acknowledged for everybody, and goes when the gateway has it no more", async () => {
    const station = opened(aStatus({ alarms: [ENDED] }));
    await user.click(within(strip()).getByRole("button", seen));
    expect(station.asked.map(({ method, path }) => `${method} ${path}`)).toEqual([
      "POST /api/v1/alarms/heartbeat_lost/acknowledge",
    ]);
    expect(traces()).toHaveLength(1);
    raise(station);
    expect(strip().textContent).toBe("Ninguna alarma.");
  });

  test("cannot be acknowledged by who has no control, and says why", async () => {
    const station = opened(aStatus({ alarms: [ENDED], control: heldBy("c2", "Ana") }));
    await user.click(within(strip()).getByRole("button", seen));
    expect(station.asked).toEqual([]);
    expect(within(strip()).getByRole("listitem").textContent).toContain("el control lo tiene Ana");
  });

  test("leaves no trace once somebody has acknowledged it, nor while it is raised again", () => {
    const station = opened();
    raise(station, { ...LOST, acknowledged: true }, { ...LOW, until_s: 1_699_999_995 });
    expect(traces()).toEqual([expect.stringContaining("batería baja")]);
    raise(station, LOW);
    expect(traces()).toEqual([]);
  });

  test("is counted beside alarms that take all the room, and is acknowledged with the rest", async () => {
    const station = opened(aStatus({ alarms: [ENDED, LOW, SLOW] }));
    const more = within(strip()).getByRole("button", {
      name: "+1 terminada sin reconocer: ver la lista",
    });
    // Who speaks to the computer says what is seen.
    expect(more.getAttribute("aria-label")).toContain(more.textContent);
    await user.click(more);
    expect(station.page.settings.getState().choices["tab"]).toBe("alarms");
    await user.click(within(strip()).getByRole("button", { name: "Reconocer todas" }));
    expect(station.asked.map(({ path }) => path).sort()).toEqual([
      "/api/v1/alarms/battery_low/acknowledge",
      "/api/v1/alarms/cpu_high/acknowledge",
      "/api/v1/alarms/heartbeat_lost/acknowledge",
    ]);
  });
});

describe("a gateway that was not heard for a while", () => {
  function back(): Station {
    const station = opened(aStatus({ alarms: [ENDED] }));
    station.breakOff();
    expect(traces()).toEqual([]);
    station.pass(300);
    raise(station, ENDED);
    return station;
  }

  test("leaves a trace too, beside what the gateway tells", () => {
    back();
    expect(traces()).toEqual([
      expect.stringContaining("estación perdida"),
      expect.stringContaining("latido perdido"),
    ]);
  });

  test("is acknowledged on this page alone, which asks nobody", async () => {
    const station = back();
    await user.click(
      within(strip()).getByRole("button", { name: "Reconocer que terminó: estación perdida" }),
    );
    expect(traces()).toEqual([expect.stringContaining("latido perdido")]);
    expect(station.asked).toEqual([]);
    expect(station.page.parts.get(ALARM_LOG).store.getState().ownPast).toMatchObject([
      { id: "gateway_lost", acknowledged: true },
    ]);
  });

  test("and is not heard again leaves no trace of the first time beside its alarm", () => {
    const station = back();
    station.breakOff();
    expect(traces()).toEqual([]);
    expect(within(strip()).getByRole("alert").textContent).toContain("No hay conexión con la estación");
  });
});

describe("a board that started anew", () => {
  const data = { silent_s: null, uptime_ms: 1200, parameters: ["k_roll", "k_pitch"], plans: ["hil"] };
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
    expect(strip().textContent).toBe("Ninguna alarma.");
    expect(station.asked).toEqual([]);
    expect(station.page.parts.get(ALARM_LOG).store.getState().ownPast).toMatchObject([
      { id: "board_restarted", acknowledged: true },
    ]);
  });

  test("that had nothing to lose is told all the same", () => {
    const station = opened();
    const nothing = { silent_s: null, uptime_ms: null, parameters: [], plans: [] };
    station.deliver({ type: "event", event: "board_restarted", t_s: 1_699_999_998, data: nothing });
    expect(within(strip()).getByRole("alert").textContent).toContain("La placa se ha reiniciado");
  });
});

describe("the number on the tab", () => {
  function numbered(...alarms: Status["alarms"]): HTMLElement | null {
    const station = new Station(
      <WordsProvider words={WORDS}>
        <UnseenAlarms />
      </WordsProvider>,
    );
    station.greet();
    raise(station, ...alarms);
    return [...document.querySelectorAll<HTMLElement>(".alarms-unseen")].at(-1) ?? null;
  }

  test("counts what nobody has acknowledged, also what came and went", () => {
    expect(numbered(ENDED, LOW, { ...SLOW, acknowledged: true })?.dataset["count"]).toBe("2");
  });

  test("has the colour of the most urgent one", () => {
    expect(numbered(LOST, LOW)?.dataset["level"]).toBe("critical");
    expect(numbered(LOW)?.dataset["level"]).toBe("warning");
  });

  test("is not there when all is known", () => {
    expect(numbered({ ...LOST, acknowledged: true })).toBeNull();
  });
});
