import { act, cleanup, screen, within } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { beforeEach, describe, expect, test } from "vitest";
import type { Status } from "../../protocol/contract";
import { anAround, aStatus, heldBy } from "../../test/aStatus";
import { type FakeRequest, Station } from "../../test/station";
import { Tab } from "../../test/tab";

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
const PAST = { ...LOW, since_s: 1_699_999_000, until_s: 1_699_999_065, acknowledged: true };
const BATTERY = { name: "battery_low_v", value: 11, default: 10.5, minimum: 0, maximum: 60, unit: "V" };
const PACK = { highest_v: 41, cells: 10, is_guessed: true, low_v: 35 };

let station: Station;

function asked(method: string, path: string): FakeRequest[] {
  return station.asked.filter((question) => question.method === method && question.path === path);
}

function raise(...alarms: Status["alarms"]): void {
  station.status(aStatus({ alarms }));
}

function panel(name: string): HTMLElement {
  return screen.getByRole("region", { name });
}

beforeEach(async () => {
  station = new Station(<Tab name="alarms" />);
  station.greet();
  station.show();
  await asked("GET", "/api/v1/alarms")[0]?.answer({ active: [], past: [PAST] });
  await asked("GET", "/api/v1/alarms/thresholds")[0]?.answer({ thresholds: [BATTERY], battery: PACK });
});

describe("what is wrong", () => {
  test("is listed with what to do about it", () => {
    expect(panel("Activas").textContent).toContain("Ninguna alarma");
    raise(LOST, LOW);
    const items = within(panel("Activas")).getAllByRole("listitem");
    expect(items[0]?.textContent).toContain("Se ha perdido el latido de la placa en pty");
    expect(items[0]?.textContent).toContain("ten a mano el transmisor RC");
    expect(items[1]?.textContent).toContain("Batería baja: 9.8 V");
  });

  test("of the ground says by which heights, and how far off they may be", () => {
    const terrain = {
      what: "terrain",
      in_s: 20,
      latitude_deg: 28,
      longitude_deg: -15,
      altitude_ft: 900,
    } as const;
    const heights = [{ name: "isla", datum: null, geoid_m: 42.1 }];
    const flight = anAround({ blind: null, ground_ft: 900, height_ft: 200, terrain, heights });
    const ahead = { ...LOST, id: "terrain_ahead", params: { aircraft: "flight" } };
    station.status(aStatus({ alarms: [ahead], surroundings: { flight, hil: anAround() } }));
    const [item] = within(panel("Activas")).getAllByRole("listitem");
    expect(item?.textContent).toContain("las alturas de isla, de las que nadie ha dicho desde dónde cuentan");
    expect(item?.textContent).toContain("pueden estar mal en 138 ft");
  });

  test("is acknowledged one by one, or all at once", async () => {
    raise(LOST, LOW);
    await user.click(within(panel("Activas")).getByRole("button", { name: /^Reconocer: Batería baja/ }));
    expect(asked("POST", "/api/v1/alarms/battery_low/acknowledge")).toHaveLength(1);
    await user.click(within(panel("Activas")).getByRole("button", { name: "Reconocer todas" }));
    expect(asked("POST", "/api/v1/alarms/heartbeat_lost/acknowledge")).toHaveLength(1);
  });

  test("and is known to somebody is shown as such, and offers nothing more", () => {
    raise({ ...LOST, acknowledged: true });
    expect(panel("Activas").textContent).toContain("reconocida");
    expect(within(panel("Activas")).queryByRole("button", { name: /^Reconocer:/ })).toBeNull();
    expect(
      within(panel("Activas")).getByRole("button", { name: "Reconocer todas" }).getAttribute("aria-disabled"),
    ).toBe("true");
  });
});

test("what recovered is listed until it is acknowledged: one by one, or with all", async () => {
  raise({ ...LOST, until_s: 1_700_000_000 }, { ...LOW, until_s: 1_700_000_000 });
  expect(panel("Activas").textContent).toContain("Falta reconocer 2 que ya terminaron");
  expect(panel("Activas").textContent).toContain("nadie la reconoció");
  const seen = { name: "Reconocer que terminó: batería baja" };
  await user.click(within(panel("Activas")).getByRole("button", seen));
  expect(asked("POST", "/api/v1/alarms/battery_low/acknowledge")).toHaveLength(1);
  raise({ ...LOST, until_s: 1_700_000_000 });
  expect(within(panel("Activas")).queryByRole("button", seen)).toBeNull();
  await user.click(within(panel("Activas")).getByRole("button", { name: "Reconocer todas" }));
  expect(asked("POST", "/api/v1/alarms/heartbeat_lost/acknowledge")).toHaveLength(1);
});

test("a viewer cannot acknowledge, nor move a threshold, and is told why", async () => {
  station.status(aStatus({ alarms: [LOST], control: heldBy("c2", "Ana") }));
  await user.click(within(panel("Activas")).getByRole("button", { name: /^Reconocer: Se ha/ }));
  await user.click(within(panel("Umbrales")).getByRole("button", { name: /^Valor de fábrica: Batería/ }));
  expect(station.asked.filter(({ method }) => method !== "GET")).toEqual([]);
  expect(panel("Activas").textContent).toContain("Espectador: el control lo tiene Ana.");
});

describe("what is over", () => {
  test("is listed with its times, and read again when the gateway reports an alarm", async () => {
    const row = within(panel("Pasadas")).getAllByRole("row")[1];
    expect(row?.textContent).toContain("Batería baja: 9.8 V");
    expect(row?.textContent).toContain("1 min");
    expect(row?.textContent).toContain("sí");
    station.deliver({ type: "event", event: "alarm", t_s: 1, data: { ...LOST, active: false } });
    await asked("GET", "/api/v1/alarms")[1]?.answer({ active: [], past: [] });
    expect(panel("Pasadas").textContent).toContain("Todavía no ha pasado nada");
  });

  test("has the page's own alarm too, which nobody else can know of", () => {
    station.breakOff();
    expect(panel("Activas").textContent).toContain("No hay conexión con la estación");
    station.pass(300);
    station.greet();
    expect(panel("Activas").textContent).toContain("Ninguna alarma");
    expect(panel("Pasadas").textContent).toContain("No hay conexión con la estación");
  });
});

test("the page's own alarm is acknowledged here and asks the gateway nothing", async () => {
  station.breakOff();
  await user.click(within(panel("Activas")).getByRole("button", { name: /^Reconocer: No hay conexión/ }));
  station.show();
  expect(panel("Activas").textContent).toContain("reconocida");
  expect(station.asked.filter(({ method }) => method === "POST")).toEqual([]);
});

describe("a threshold", () => {
  function field(): HTMLElement {
    return within(panel("Umbrales")).getByRole("textbox", { name: /Batería baja/ });
  }

  test("shows its value, its range and its default", () => {
    expect((field() as HTMLInputElement).value).toBe("11");
    expect(panel("Umbrales").textContent).toContain("0 a 60 V");
    expect(panel("Umbrales").textContent).toContain("de fábrica 10.5 V");
  });

  test("is changed on Enter and not by a key, and stands as the gateway answers", async () => {
    await user.clear(field());
    await user.type(field(), "9.9");
    expect(asked("PUT", "/api/v1/alarms/thresholds")).toEqual([]);
    await user.keyboard("{Enter}");
    const [question] = asked("PUT", "/api/v1/alarms/thresholds");
    expect(question?.body).toEqual({ battery_low_v: 9.9 });
    await question?.answer({ thresholds: [{ ...BATTERY, value: 9.9 }], battery: null });
    expect((field() as HTMLInputElement).value).toBe("9.9");
  });

  test("out of its range is refused here", async () => {
    await user.clear(field());
    await user.type(field(), "61{Enter}");
    expect(asked("PUT", "/api/v1/alarms/thresholds")).toEqual([]);
    expect(panel("Umbrales").textContent).toContain("entre 0 y 60");
  });

  test("goes back to its default with one press", async () => {
    await user.click(within(panel("Umbrales")).getByRole("button", { name: /^Valor de fábrica: Batería/ }));
    expect(asked("PUT", "/api/v1/alarms/thresholds")[0]?.body).toEqual({ battery_low_v: 10.5 });
  });
});

test("an alarm that came again and again is one line with its count, and a press shows each", async () => {
  raise({ ...LOW, count: 3 }, { ...LOST, until_s: 1_699_999_999, count: 2 });
  expect(panel("Activas").textContent).toMatch(/× 3/);
  expect(panel("Activas").textContent).toMatch(/× 2/);
  const again = (minute: number) => ({
    ...PAST,
    since_s: 1_699_990_000 + 60 * minute,
    until_s: 1_699_990_010 + 60 * minute,
  });
  station.deliver({ type: "event", event: "alarm", t_s: 1, data: { ...LOW, active: false } });
  await asked("GET", "/api/v1/alarms")
    .at(-1)
    ?.answer({ active: [], past: [again(2), again(1), again(0)].map(({ count: _, ...past }) => past) });
  const lines = () => within(panel("Pasadas")).getAllByRole("row").slice(1);
  expect(lines()).toHaveLength(1);
  expect(lines()[0]?.textContent).toContain("30 s");
  await user.click(within(panel("Pasadas")).getByRole("button", { name: "3 veces: ver cada una" }));
  expect(lines()).toHaveLength(4);
});

test("the cells of the battery are guessed aloud, and one press says how many there are", async () => {
  expect(panel("Umbrales").textContent).toContain("ha llegado a 41 V y se toma por una de 10 celdas");
  await user.click(within(panel("Umbrales")).getByRole("button", { name: "Tiene 11" }));
  const [question] = asked("PUT", "/api/v1/alarms/thresholds");
  expect(question?.body).toEqual({ battery_cells: 11 });
  const told = { ...PACK, cells: 11, low_v: 38.5, is_guessed: false };
  await question?.answer({ thresholds: [BATTERY], battery: told });
  expect(panel("Umbrales").textContent).toContain("por debajo de 38.5 V, para 11 celdas");
  expect(within(panel("Umbrales")).queryByRole("button", { name: /^Tiene/ })).toBeNull();
});

describe("what is heard", () => {
  test("follows the alarms: a tone, again for a critical one, none once it is acknowledged", () => {
    raise(LOST);
    expect(station.sounder.played).toEqual(["critical"]);
    for (let time = 0; time < 5; time += 1) {
      station.pass(700);
      raise(LOST);
    }
    expect(station.sounder.played).toEqual(["critical", "critical"]);
    raise({ ...LOST, acknowledged: true });
    const before = station.sounder.played.length;
    for (let time = 0; time < 6; time += 1) {
      station.pass(700);
      raise({ ...LOST, acknowledged: true });
    }
    expect(station.sounder.played.length).toBe(before);
  });

  test("a tone that fails keeps neither the voice nor the next tone away", async () => {
    await user.click(
      within(panel("Sonido y voz")).getAllByRole("checkbox", { name: "Alarmas" })[1] as HTMLElement,
    );
    station.sounder.failure = new Error("no sound device");
    raise(LOST);
    expect(station.reported).toEqual([station.sounder.failure]);
    station.sounder.failure = null;
    expect(station.speaker.said).toEqual(["es: Alarma: latido perdido."]);
    station.pass(3500);
    expect(station.sounder.played).toEqual(["critical"]);
  });

  test("is spoken where it is wanted, in the page's language, and says recovered only when it is", async () => {
    await user.click(
      within(panel("Sonido y voz")).getAllByRole("checkbox", { name: "Alarmas" })[1] as HTMLElement,
    );
    raise(LOST);
    expect(station.speaker.said).toEqual(["es: Alarma: latido perdido."]);
    station.status(aStatus({ board: { ...aStatus().board, state: "closed" } }));
    expect(station.speaker.said.at(-1)).toBe("hush");
    const again = { ...LOST, since_s: 1_699_999_999 };
    raise(again);
    station.send({ heartbeat: { ahrs: true } });
    raise({ ...again, until_s: 1_700_000_001 });
    expect(station.speaker.said.at(-1)).toBe("es: Recuperado. Era: latido perdido.");
  });

  test("is nothing for two minutes after mute, and the seconds left are told", async () => {
    raise(LOST);
    await user.click(within(panel("Sonido y voz")).getByRole("button", { name: "Silencio 2 min" }));
    station.show();
    const before = station.sounder.played.length;
    expect(within(panel("Sonido y voz")).getByRole("button", { name: /^Silencio: 1(20|19) s/ })).toBeTruthy();
    // Nothing comes in this time, so that the page's own alarm is raised too.
    station.pass(119_000);
    expect(station.sounder.played.length).toBe(before);
    station.pass(2000);
    expect(station.sounder.played.at(-1)).toBe("critical");
    expect(within(panel("Sonido y voz")).getByRole("button", { name: "Silencio 2 min" })).toBeTruthy();
  });

  test("is a tone where the voice does not begin, and the user is told of it once", async () => {
    station.speaker.isHeard = false;
    const tries = () => user.click(screen.getByRole("button", { name: "Probar la voz de una alarma" }));
    await tries();
    await tries();
    expect(station.sounder.played).toEqual(["critical", "critical"]);
    const said = () => station.page.messages.getState().kept.filter(({ key }) => key === "alarmSaid.unheard");
    expect(said()).toHaveLength(1);
    station.speaker.isHeard = true;
    await tries();
    station.speaker.isHeard = false;
    await tries();
    expect(said()).toHaveLength(2);
  });

  test("can be tried, whatever is switched off", async () => {
    await user.click(screen.getByRole("button", { name: "Probar el sonido de un aviso" }));
    await user.click(screen.getByRole("button", { name: "Probar la voz de una alarma" }));
    expect(station.sounder.played).toEqual(["warning"]);
    expect(station.speaker.said).toEqual(["es: Prueba de voz: así suena una alarma."]);
  });

  test("waits for a press where the browser wants one, and says so", () => {
    act(() => station.sounder.become("waits"));
    station.show();
    raise(LOW);
    expect(station.sounder.played).toEqual([]);
    expect(panel("Sonido y voz").textContent).toContain("no deja sonar nada hasta que toques la página");
    act(() => station.sounder.become("ready"));
    station.show();
    expect(station.sounder.played).toEqual(["warning"]);
  });

  test("without a voice of the language says so, and the button says why", () => {
    act(() => station.speaker.become("foreign"));
    station.show();
    expect(panel("Sonido y voz").textContent).toContain("no tiene ninguna voz en español");
    expect(
      screen.getByRole("button", { name: "Probar la voz de un aviso" }).getAttribute("aria-disabled"),
    ).toBe("true");
  });
});

test("with more alarms than two lines the strip counts the others and leads to the list", async () => {
  cleanup();
  station = new Station();
  station.greet();
  raise(LOST, LOW, { ...LOW, id: "cpu_high" }, { ...LOW, id: "gps_lost" });
  const strip = screen.getByRole("region", { name: "Alarmas" });
  expect(within(strip).getAllByRole("button", { name: /^Reconocer:/ })).toHaveLength(2);
  await user.click(within(strip).getByRole("button", { name: "Ver la lista: hay 2 alarmas más" }));
  expect(screen.getByRole("tab", { name: "Alarmas" }).getAttribute("aria-selected")).toBe("true");
});

test("in the past nothing is said of this browser's sound: only the present is heard", () => {
  expect(panel("Sonido y voz").textContent).not.toContain("no puede sonar");
  station.openFlight("20260131T120000Z", 10);
  expect(screen.queryByText(/no puede sonar/)).toBeNull();
  expect(screen.queryByRole("region", { name: "Sonido y voz" })).toBeNull();
});
