import { cleanup, screen, within } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { beforeEach, describe, expect, test } from "vitest";
import type { Inspection } from "../../protocol/contract";
import { type FakeRequest, Station } from "../../test/station";
import { Tab } from "../../test/tab";

const user = userEvent.setup();
let station: Station;

const inspection: Inspection = {
  t_s: 1_700_000_000,
  board: [
    {
      id: 1,
      name: "ahrs",
      count: 1234,
      rate_hz: 9.96,
      jitter_ms: 1.24,
      damaged: 3,
      age_s: 0.05,
      stale_after_s: 0.3,
      values: { yaw_deg: 359.9996, pitch_deg: null, roll_deg: -1234.5 },
      units: { yaw_deg: "deg", pitch_deg: "deg", roll_deg: "deg" },
    },
    {
      id: 0x104,
      name: "mission_count",
      count: 0,
      rate_hz: 0,
      jitter_ms: null,
      damaged: 0,
      age_s: null,
      stale_after_s: null,
      values: null,
      units: {},
    },
  ],
  rows: [
    {
      row: 17,
      name: "attitude",
      expected: true,
      count: 50,
      rate_hz: 50,
      jitter_ms: 0.2,
      age_s: 0.02,
      values: [1.25, -999, 3, 4, 5, 6, 7, 8],
    },
  ],
  link: {
    rx_bytes_per_s: 5705,
    tx_bytes_per_s: 3769,
    capacity_bytes_per_s: 11520,
    rx_percent: 49.5,
    tx_percent: 32.7,
    simulator_bytes_per_s: 18100,
    simulator_percent: 24.8,
    round_trip_ms: { newest: 9.81, p50: 9.94, p99: 12.5 },
    round_trips: 1933,
  },
  advice: [],
};

function questions(): FakeRequest[] {
  return station.asked.filter(({ path }) => path === "/api/v1/inspector");
}

async function answered(parts: Partial<Inspection> = {}): Promise<void> {
  station.pass(600);
  await questions()
    .at(-1)
    ?.answer({ ...inspection, ...parts });
}

function row(name: string): HTMLElement {
  const found = screen.getByRole("button", { name }).closest("tr");
  if (found === null) {
    throw new Error(`${name} stands in no row`);
  }
  return found;
}

function cells(name: string): string[] {
  return within(row(name))
    .getAllByRole("cell")
    .map((cell) => cell.textContent ?? "");
}

beforeEach(() => {
  station = new Station(<Tab name="messages" />);
  station.greet();
  station.show();
});

describe("the gateway is asked", () => {
  test("while the tab is open, once at a time", async () => {
    station.pass(5000);
    expect(questions()).toHaveLength(1);
    await questions()[0]?.answer(inspection);
    station.pass(600);
    expect(questions()).toHaveLength(2);
  });

  test("no longer when the tab is left", async () => {
    await answered();
    const before = questions().length;
    cleanup();
    station.pass(5000);
    expect(questions()).toHaveLength(before);
  });

  test("and what it cannot answer is said in words", async () => {
    await questions()[0]?.answer("<html>", 502);
    expect(screen.getByRole("tabpanel", { name: "Mensajes" }).textContent).toContain("502");
  });
});

describe("the board's messages", () => {
  beforeEach(() => answered());

  test("stand with how they come, also those that never did", () => {
    expect(cells("ahrs")).toEqual(["1", "10.0", "1.2", "1234", "3", "0.1 s"]);
    expect(cells("mission_count")).toEqual(["0x104", "0.0", "–", "0", "0", "nunca"]);
  });

  test("unfold their last values, whole and with units; no data is no number", async () => {
    await user.click(screen.getByRole("button", { name: "ahrs" }));
    const values = row("ahrs").nextElementSibling?.textContent ?? "";
    expect(values).toContain("yaw_deg359.9996°");
    expect(values).toContain("pitch_degSIN DATOS");
    expect(values).toContain("roll_deg-1234.500°");
    await user.click(screen.getByRole("button", { name: "ahrs" }));
    expect(screen.queryByText("yaw_deg")).toBeNull();
  });

  test("are drawn at a press, several at once, and taken out again", async () => {
    await user.click(screen.getByRole("button", { name: "ahrs" }));
    await user.click(screen.getByRole("button", { name: "Graficar roll_deg" }));
    await user.click(screen.getByRole("button", { name: "Graficar yaw_deg" }));
    station.send({ ahrs: { roll_deg: 12.5, yaw_deg: 90 } });
    const plot = screen.getByRole("figure", { name: "Gráfica" });
    expect(plot.textContent).toContain("ahrs.roll_deg12.500°");
    expect(plot.textContent).toContain("ahrs.yaw_deg90.000°");
    await user.click(screen.getByRole("button", { name: "Graficar roll_deg" }));
    station.show();
    expect(screen.getByRole("figure", { name: "Gráfica" }).textContent).not.toContain("roll_deg");
  });

  test("that become stale are marked", async () => {
    const [ahrs, ...rest] = inspection.board;
    await answered({ board: ahrs === undefined ? rest : [{ ...ahrs, age_s: 2.5 }, ...rest] });
    expect(row("ahrs").dataset["state"]).toBe("stale");
    expect(cells("ahrs").at(-1)).toContain("no actual");
  });
});

test("the simulator's rows stand with their eight values, and can be drawn", async () => {
  await answered();
  await user.click(screen.getByRole("tab", { name: "X-Plane" }));
  expect(row("attitude").textContent).toContain("la usa el HIL");
  await user.click(screen.getByRole("button", { name: "attitude" }));
  expect(row("attitude").nextElementSibling?.textContent).toContain("1 roll_degSIN DATOS");
  await user.click(screen.getByRole("button", { name: "Graficar 0 pitch_deg" }));
  station.rows({ 17: [1.25, -999, 3, 4, 5, 6, 7, 8] });
  expect(screen.getByRole("figure", { name: "Gráfica" }).textContent).toContain("17: pitch_deg1.2500°");
});

test("the link page tells what the lines carry of what they can, and how long the loop takes", async () => {
  await answered();
  await user.click(screen.getByRole("tab", { name: "Enlace" }));
  const panel = screen.getByRole("tabpanel", { name: "Enlace" }).textContent ?? "";
  expect(panel).toContain("50 %");
  expect(panel).toContain("5705 de 11520 B/s");
  expect(panel).toContain("18100 B/s");
  expect(panel).toContain("9.8 ms");
  expect(panel).toContain("12.5 ms");
});

describe("advice", () => {
  function advice(): string {
    return screen.getByRole("region", { name: "Consejos" }).textContent ?? "";
  }

  test("is that all goes well when it does", async () => {
    await answered();
    expect(advice()).toBe("Todo va bien: no hay nada que aconsejar.");
  });

  test("is said in the page's language, with what it is about", async () => {
    await answered({
      advice: [
        { code: "row_missing", level: "warning", text: "…", params: { row: 18, name: "alpha_beta_paths" } },
        { code: "line_full", level: "warning", text: "…", params: { percent: 96, direction: "rx" } },
        { code: "added_later", level: "info", text: "Look up.", params: {} },
      ],
    });
    expect(advice()).toContain("La trama 18 (AoA, beta, trayectorias) no se está enviando");
    expect(advice()).toContain("La línea desde la placa está al 96 %");
    expect(advice()).toContain("Look up.");
  });

  test("on slow streams names each with its rates, and many in one sentence", async () => {
    const one = { topic: "ahrs", rate_hz: 6.8, expected_hz: 10 };
    await answered({ advice: [{ code: "stream_slow", level: "info", text: "…", params: one }] });
    expect(advice()).toContain("ahrs llega 6.8 veces por segundo y debería llegar 10.");
    const many = { number: 3, list: "ahrs 6.8/10 Hz, gps 2/5 Hz, inertial 0/10 Hz" };
    await answered({ advice: [{ code: "streams_slow", level: "info", text: "…", params: many }] });
    expect(advice()).toContain("3 flujos llegan más despacio");
    expect(advice()).toContain("inertial 0/10 Hz");
  });
});

describe("in the past", () => {
  const then: Inspection = {
    ...inspection,
    link: {
      ...inspection.link,
      round_trip_ms: { newest: null, p50: null, p99: null },
      round_trips: null,
    },
  };

  beforeEach(async () => {
    station.openFlight("current", 100);
    station.pass(600);
    expect(station.replay.questions).toContain("inspector");
  });

  test("the replay is asked, and not the gateway, for what was counted up to the moment shown", async () => {
    await station.answered("inspector", then);
    expect(cells("ahrs").slice(1, 4)).toEqual(["10.0", "1.2", "1234"]);
    station.pass(600);
    expect(questions(), "the one before the past was opened").toHaveLength(1);
  });

  test("nothing is advised, and what no recording tells says so", async () => {
    await station.answered("inspector", then);
    expect(screen.getByRole("region", { name: "Consejos" }).textContent).toContain("solo para el presente");
    await user.click(screen.getByRole("tab", { name: "Enlace" }));
    const panel = screen.getByRole("tabpanel", { name: "Enlace" }).textContent ?? "";
    expect(panel).toContain("La grabación no lo dice");
  });

  test("an answer that is none is said in words", async () => {
    await station.answered("inspector", { board: "?" });
    expect(screen.queryByText(/La reproducción no responde/)).not.toBeNull();
  });
});
