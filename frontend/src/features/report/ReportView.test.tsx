import { act, screen, within } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { beforeEach, describe, expect, test, vi } from "vitest";
import { formatDateTime } from "../../lib/moment";
import type { FlightReport } from "../../protocol/guards.gen";
import { aManoeuvre, aReport } from "../../test/flightReport";
import { Station } from "../../test/station";
import { WORDS } from "../../ui/test/testWords";
import { WordsProvider } from "../../ui/words";
import { ReportView } from "./ReportView";
import { REPORTS } from "./reportRequests";

const user = userEvent.setup({ delay: null });
const FLIGHT = aReport().flight;
const OTHER = "20231113T090000Z";
const OTHERS = [
  { id: FLIGHT, name: "Primera vuelta" },
  { id: OTHER, name: "Segunda" },
];

let station: Station;

beforeEach(() => {
  station = new Station(
    <WordsProvider words={WORDS}>
      <ReportView name="Primera vuelta" others={OTHERS} />
    </WordsProvider>,
  );
  station.greet();
});

function open(): void {
  act(() => station.page.parts.get(REPORTS).open(FLIGHT));
}

async function answer(report: unknown, status = 200): Promise<void> {
  await station.asked
    .filter(({ path }) => path.includes("/report"))
    .at(-1)
    ?.answer(report, status);
}

async function show(parts: Partial<FlightReport> = {}): Promise<void> {
  open();
  await answer(aReport(parts));
}

/** What stands beside a figure's name, in each table that has it. */
function figures(name: string, where: HTMLElement = document.body): string[][] {
  return within(where)
    .getAllByText(name, { selector: "th[scope=row] button" })
    .map((head) => [...(head.closest("tr")?.querySelectorAll("td") ?? [])].map((cell) => cell.textContent));
}

function section(name: string): HTMLElement {
  return screen.getByRole("heading", { name, level: 3 }).closest("section") as HTMLElement;
}

describe("a report", () => {
  test("is not there until it is opened, says that it is made, and goes when it is closed", async () => {
    expect(screen.queryByRole("region", { name: "Informe de vuelo" })).toBeNull();
    open();
    expect(screen.getByText("Haciendo el informe…")).toBeTruthy();
    await answer(aReport());
    expect(screen.queryByText("Haciendo el informe…")).toBeNull();
    await user.click(screen.getByRole("button", { name: "Cerrar informe" }));
    expect(screen.queryByRole("region", { name: "Informe de vuelo" })).toBeNull();
  });

  test("that cannot be made says why, and is asked for again with one press", async () => {
    open();
    await answer({ code: "recording_unreadable", detail: "x", params: { reason: "sin cabecera" } }, 409);
    expect(screen.getByRole("alert").textContent).toContain("sin cabecera");
    await user.click(screen.getByRole("button", { name: "Reintentar" }));
    expect(screen.queryByRole("alert")).toBeNull();
    await answer(aReport());
    expect(figures("Duración")).toEqual([["12:34"]]);
  });

  test("names the flight, its start and who flew what", async () => {
    await show({
      identity: {
        board: "epf",
        firmware: "1.0",
        aircraft: "Ala 3",
        operator: "Ana",
        station: "0.1.0",
        emulated: false,
      },
    });
    const sheet = screen.getByRole("article").textContent;
    expect(sheet).toContain(`Primera vuelta · ${formatDateTime(1_699_956_000)}`);
    expect(sheet).toContain(`Ala 3 · epf · 1.0 · Ana · ${FLIGHT}`);
  });

  test("gives times, distances, battery and link with their units", async () => {
    await show();
    for (const [name, text] of [
      ["Tiempo en vuelo", "10:00"],
      ["Distancia", "9.87 NM"],
      ["Altitud máxima", "1234 ft"],
      ["Mayor ascenso", "900 ft/min"],
      ["Batería mínima", "11.20 V"],
      ["Caída por hora", "2.86 V/h"],
      ["Tramas dañadas", "9 (0.010 %)"],
      ["Silencios", "0"],
      ["Ida y vuelta HIL", "4.0 ms, p99 9.5 ms, máx. 21.0 ms"],
    ] as const) {
      expect([name, figures(name)]).toEqual([name, [[text]]]);
    }
  });

  test("shows a dash for what is not known, and no battery where the board measured none", async () => {
    const { times, distances, link } = aReport();
    await show({
      times: { ...times, airborne_s: null },
      distances: { ...distances, distance_nm: null },
      link: { ...link, gaps: 2, gaps_s: 7.25, longest_gap_s: 4, round_trip_ms: null },
      battery: null,
      unknown: ["battery", "round_trip"],
    });
    expect(figures("Tiempo en vuelo")).toEqual([["—"]]);
    expect(figures("Distancia")).toEqual([["—"]]);
    expect(figures("Ida y vuelta HIL")).toEqual([["—"]]);
    expect(figures("Silencios")).toEqual([["2, 7.3 s en total, el más largo 4.0 s"]]);
    expect(screen.queryByRole("heading", { name: "Batería" })).toBeNull();
    expect(within(section("Lo que este informe no puede saber")).getAllByRole("listitem")).toHaveLength(2);
  });

  test("lists the alarms with how long each lasted, and the marks", async () => {
    await show({
      alarms: [
        { name: "battery_low", at_s: 62, lasted_s: 3.25, level: "warning", count: 23 },
        { name: "of_a_newer_station", at_s: 700, lasted_s: null, level: null, count: 1 },
      ],
      marks: [{ at_s: 125, text: "viraje raro" }],
    });
    const alarms = within(section("Alarmas")).getAllByRole("listitem");
    expect(alarms.map(({ textContent }) => textContent)).toEqual([
      "1:02  batería baja × 23: 3.3 s",
      "11:40  of_a_newer_station: hasta el final",
    ]);
    expect(section("Marcas").textContent).toContain("2:05  viraje raro");
  });

  test("says so when nothing sounded, no gain was changed and nothing was flown", async () => {
    await show();
    expect(section("Alarmas").textContent).toContain("No sonó ninguna alarma.");
    expect(section("Ganancias cambiadas en vuelo").textContent).toContain("No se cambió ninguna ganancia");
    expect(section("Maniobras").textContent).toContain("ningún objetivo cambió lo bastante");
    expect(screen.queryByRole("heading", { name: "Marcas" })).toBeNull();
    expect(screen.queryByRole("heading", { name: "Lazos: medianas del vuelo" })).toBeNull();
  });

  test("says what a figure means when its name is pressed", async () => {
    await show();
    await user.click(screen.getByRole("button", { name: "Qué es: Caída por hora" }));
    const meaning = screen.getByRole("dialog", { name: "Caída por hora" });
    expect(meaning.textContent).toContain("No es la carga gastada");
    await user.click(within(meaning).getByRole("button"));
    expect(screen.queryByRole("dialog")).toBeNull();
  });

  test("is printed, and has a page of its own for others", async () => {
    const print = vi.spyOn(window, "print").mockImplementation(() => undefined);
    await show();
    await user.click(screen.getByRole("button", { name: "Imprimir" }));
    expect(print).toHaveBeenCalledOnce();
    expect(screen.getByRole("link", { name: "Página aparte" }).getAttribute("href")).toBe(
      `/api/v1/flights/${FLIGHT}/report?format=html&lang=es`,
    );
  });
});

describe("a manoeuvre", () => {
  test("has its cause, its picture and the figures of its answer", async () => {
    await show({ no_manoeuvres: null, manoeuvres: [aManoeuvre({ waypoint: 2, cause: "waypoint" })] });
    const flown = section("Maniobras");
    expect(within(flown).getByRole("heading", { level: 4 }).textContent).toBe(
      "Ascenso a los 1:05 · waypoint 3",
    );
    expect(flown.textContent).toContain("al cambiar de waypoint");
    expect(within(flown).getByRole("img", { name: "Ascenso a los 1:05: señal y objetivo" })).toBeTruthy();
    expect(figures("Escalón", flown)).toEqual([["100.0 ft"]]);
    expect(figures("Sobreoscilación", flown)).toEqual([["12.2 %"]]);
    expect(figures("Tiempo de subida del modelo", flown)).toEqual([["4.1 ± 0.2 s"]]);
    expect(figures("Amortiguamiento", flown)).toEqual([["0.55"]]);
    expect(figures("Modelo fuera de las muestras", flown)).toEqual([["1.2 ft"]]);
    expect(flown.textContent).not.toContain("Acabó antes");
  });

  test("that no model explains has none of a model, and one that ended early says so", async () => {
    const cut = aManoeuvre({ model: null, is_cut: true, settling_s: null, steady_error: null });
    await show({ no_manoeuvres: null, manoeuvres: [cut] });
    const flown = section("Maniobras");
    expect(figures("Error permanente", flown)).toEqual([["—"]]);
    expect(within(flown).queryByText("Amortiguamiento")).toBeNull();
    expect(flown.textContent).toContain("Acabó antes de que la respuesta quedara en reposo");
  });

  test("whose answer cannot be judged has no figures, and says why", async () => {
    await show({ no_manoeuvres: null, manoeuvres: [aManoeuvre({ method: "none" })] });
    const flown = section("Maniobras");
    expect(flown.textContent).toContain("Sin cifras: la respuesta fue demasiado corta");
    expect(within(flown).queryByRole("table")).toBeNull();
  });

  test("to a waypoint has the figures of its leg, also where some are not known", async () => {
    const leg = {
      duration_s: 90,
      distance_m: 1500,
      across_rms_m: 12.4,
      across_most_m: 40,
      altitude_error_ft: null,
      speed_error_kt: -0.004,
    };
    await show({
      no_manoeuvres: null,
      manoeuvres: [
        aManoeuvre({ kind: "leg", method: "none", leg }),
        aManoeuvre({
          kind: "leg",
          method: "none",
          at_s: 200,
          leg: { ...leg, across_rms_m: null, distance_m: null },
        }),
      ],
    });
    const flown = section("Maniobras");
    expect(figures("Desvío lateral", flown)).toEqual([["12 m eficaz, 40 m máx."], ["—"]]);
    expect(figures("Distancia", flown)).toEqual([["1500 m"], ["—"]]);
    expect(figures("Error de altitud", flown)).toEqual([["—"], ["—"]]);
    expect(figures("Error de velocidad", flown)).toEqual([["0.00 kt"], ["0.00 kt"]]);
  });
});

describe("the picture of a manoeuvre", () => {
  async function picture(parts: Parameters<typeof aManoeuvre>[0]): Promise<Element | null> {
    await show({ no_manoeuvres: null, manoeuvres: [aManoeuvre(parts)] });
    return document.querySelector("svg.report-picture");
  }

  test("draws a target as steps, and a missing value as a gap", async () => {
    const drawn = await picture({
      trace: {
        at_s: [0, 5, 10, 15, 20],
        value: [500, 550, null, 600, 610],
        target: [500, 600, 600, null, 600],
      },
    });
    const signal = drawn?.querySelector(".report-signal")?.getAttribute("d") ?? "";
    const target = drawn?.querySelector(".report-target")?.getAttribute("d") ?? "";
    expect(signal.replaceAll(/[^ML]/g, "")).toBe("MLML");
    expect(target.replaceAll(/[^MHV]/g, "")).toBe("MHVHVM");
  });

  test("marks rise, peak, settling and final value only where they are known and in the picture", async () => {
    const all = ".report-rise, .report-peak, .report-settled, .report-final";
    const drawn = await picture({});
    expect(drawn?.querySelectorAll(all)).toHaveLength(4);
    expect(
      (await picture({ rise_from_s: null, peak_s: 21, settling_s: 21, final: null }))?.querySelectorAll(all),
    ).toHaveLength(0);
  });

  test("is left out when there is nothing to draw", async () => {
    expect(await picture({ trace: null })).toBeNull();
    expect(await picture({ trace: { at_s: [0], value: [1], target: [2] } })).toBeNull();
    expect(await picture({ trace: { at_s: [0, 1], value: [null, null], target: [null, null] } })).toBeNull();
  });
});

describe("with an earlier flight beside it", () => {
  const loop = {
    loop: "altitude",
    manoeuvres: 3,
    rise_s: 4,
    overshoot_percent: 12,
    settling_s: 11,
    steady_error: 2,
    damping: 0.6,
    unit: "ft",
  } as const;
  const { times, distances, battery, link } = aReport();
  const earlier = {
    flight: OTHER,
    times: { ...times, started_s: 1_699_866_000, duration_s: 600 },
    distances,
    battery,
    link,
    gains: [{ name: "altitude_kp", before: 1.5, after: 2 }],
    loops: [{ ...loop, rise_s: 6 }],
    manoeuvres: [aManoeuvre({ rise_s: 7 })],
  };

  test("is asked for by choosing it, and left out again", async () => {
    await show();
    const choice = screen.getByRole("combobox", { name: "Comparar con" });
    expect(
      within(choice)
        .getAllByRole("option")
        .map(({ textContent }) => textContent),
    ).toEqual(["Ningún vuelo", "Segunda"]);
    await user.selectOptions(choice, "Segunda");
    expect(station.asked.at(-1)?.path).toBe(`/api/v1/flights/${FLIGHT}/report?compare=${OTHER}`);
    await user.selectOptions(choice, "Ningún vuelo");
    expect(station.asked.at(-1)?.path).toBe(`/api/v1/flights/${FLIGHT}/report`);
  });

  test("has each figure of both, and the gains in which they differ", async () => {
    await show({
      earlier,
      loops: [loop],
      no_manoeuvres: null,
      manoeuvres: [aManoeuvre({ earlier: 0 }), aManoeuvre({ at_s: 300 })],
    });
    const head = within(section("Tiempos y distancias")).getAllByRole("columnheader");
    expect(head.at(-1)?.textContent).toBe(`Vuelo ${formatDateTime(1_699_866_000)}`);
    expect(figures("Duración")).toEqual([["12:34", "10:00"]]);
    const [first, second] = section("Maniobras").querySelectorAll("li");
    expect(figures("Tiempo de subida", first)).toEqual([["4.0 s", "7.0 s"]]);
    expect(within(first as HTMLElement).getAllByRole("img")).toHaveLength(2);
    expect(second?.textContent).toContain("Sin maniobra parecida en el otro vuelo.");
    const medians = within(section("Lazos: medianas del vuelo")).getAllByRole("row");
    expect(medians.slice(1).map(({ textContent }) => textContent)).toEqual([
      "Altitud34.0 s12.0 %11.0 s2.0 ft0.60",
      "Otro36.0 s12.0 %11.0 s2.0 ft0.60",
    ]);
    expect(section("Ganancias cambiadas en vuelo").textContent).toContain("altitude_kp1.5 → 2");
  });
});

test("a gain that was changed in flight has its loop before and after, and one of no loop only its values", async () => {
  const effect = {
    from_s: 0,
    to_s: 100,
    manoeuvres: 2,
    rise_s: 4,
    overshoot_percent: 30,
    settling_s: null,
    steady_error: 0.126,
    damping: 0.3,
    error_rms: 1.5,
  };
  await show({
    gains: [
      {
        name: "speed_kp",
        at_s: 100,
        before: 1,
        after: 2,
        loop: "speed",
        earlier: effect,
        later: { ...effect, overshoot_percent: 10, error_rms: null },
      },
      { name: "servo_trim", at_s: 120, before: 0, after: 5, loop: null, earlier: null, later: null },
    ],
  });
  const gains = section("Ganancias cambiadas en vuelo");
  expect(
    within(gains)
      .getAllByRole("heading", { level: 4 })
      .map(({ textContent }) => textContent),
  ).toEqual(["speed_kp: 1 → 2 a los 1:40", "servo_trim: 0 → 5 a los 2:00"]);
  expect(figures("Sobreoscilación", gains)).toEqual([["30.0 %", "10.0 %"]]);
  expect(figures("Error del lazo", gains)).toEqual([["1.50 kt", "—"]]);
  expect(figures("Asentamiento", gains)).toEqual([["—", "—"]]);
  expect(within(gains).getAllByRole("table")).toHaveLength(1);
});
