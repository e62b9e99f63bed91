import { act, screen, within } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { describe, expect, test } from "vitest";
import { aStatus, heldBy } from "../../test/aStatus";
import { type FakeRequest, Station } from "../../test/station";

const heartbeat = {
  autopilot_hil: false,
  autotrim_hil: false,
  source_joystick: true,
  autopilot: false,
  autotrim: false,
};

function flying(flags: Readonly<Record<string, boolean>> = {}): Station {
  const station = new Station();
  station.greet();
  station.send({ heartbeat: { ...heartbeat, ...flags } });
  return station;
}

function control(name: string): HTMLElement {
  return screen.getByRole("group", { name });
}

function position(name: string): string | undefined {
  const chosen = within(control(name))
    .getAllByRole<HTMLInputElement>("radio")
    .find((radio) => radio.checked);
  return chosen?.value;
}

async function press(name: string, option: string): Promise<void> {
  await userEvent.setup().click(within(control(name)).getByRole("radio", { name: option }));
}

function newest(station: Station): FakeRequest {
  const asked = station.asked.at(-1);
  if (asked === undefined) {
    throw new Error("the page asked nothing");
  }
  return asked;
}

function lastMessage(): string {
  return screen.getByRole("status", { name: "Último mensaje" }).textContent ?? "";
}

describe("a switch", () => {
  test("stands where the board says, and is pending until the board proves the change", async () => {
    const station = flying();
    expect(position("Autopilot")).toBe("off");
    await press("Autopilot", "On");
    expect(newest(station)).toMatchObject({ method: "POST", path: "/api/v1/commands/autopilot_on" });
    station.show();
    expect(control("Autopilot").dataset["state"]).toBe("pending");
    expect(position("Autopilot")).toBe("off");

    await newest(station).answer({ state: "confirmed", by: "acknowledgement", ms: 18.4, reason: null });
    station.send({ heartbeat: { ...heartbeat, autopilot_hil: true } });
    expect(control("Autopilot").dataset["state"]).toBe("confirmed");
    expect(position("Autopilot")).toBe("on");
    expect(lastMessage()).toContain("Autopilot On: confirmado por la placa en 18 ms.");
  });

  test("whose command the board refuses stays where it was and says why", async () => {
    const station = flying();
    await press("Autotrim", "On");
    await newest(station).answer({ state: "rejected", by: "acknowledgement", ms: 9, reason: "bad_state" });
    expect(control("Autotrim").dataset["state"]).toBe("rejected");
    expect(position("Autotrim")).toBe("off");
    expect(lastMessage()).toContain("Autotrim On: la placa lo ha rechazado (ahora no es posible).");
  });

  test("whose command is not answered says so", async () => {
    const station = flying();
    await press("Autopilot", "On");
    await newest(station).answer({ state: "timed_out", by: "heartbeat", ms: 1200, reason: null });
    expect(control("Autopilot").dataset["state"]).toBe("timed_out");
    expect(lastMessage()).toContain("Autopilot On: sin respuesta de la placa.");
  });

  test("whose question the gateway refuses shows the sentence of the problem, translated", async () => {
    const station = flying();
    await press("X-Plane", "Manual");
    expect(newest(station)).toMatchObject({ method: "PUT", path: "/api/v1/hil", body: { path: "manual" } });
    await newest(station).answer(
      { code: "control_held", detail: "Ana has control.", params: { name: "Ana" }, status: 409 },
      409,
    );
    expect(control("X-Plane").dataset["state"]).toBe("rejected");
    expect(lastMessage()).toContain("El control lo tiene Ana");
  });

  test("does not know its position once the heartbeat is stale", () => {
    const station = flying({ autopilot_hil: true });
    expect(position("Autopilot")).toBe("on");
    station.pass(700);
    station.status(aStatus());
    expect(position("Autopilot")).toBeUndefined();
    expect(position("Fuente")).toBeUndefined();
  });
});

describe("X-Plane by hand", () => {
  test("in automatic flight is asked for first, and nothing is sent when it is left", async () => {
    const station = flying({ autopilot_hil: true });
    await press("X-Plane", "Manual");
    expect(station.asked).toEqual([]);
    const question = screen.getByRole("alertdialog", { name: "¿Llevar X-Plane a mano?" });
    expect(question.textContent).toContain("El autopilot está volando");
    await userEvent.setup().click(within(question).getByRole("button", { name: "Cancelar" }));
    expect(station.asked).toEqual([]);
    expect(position("X-Plane")).toBe("assisted");
  });

  test("in automatic flight is sent once it is confirmed", async () => {
    const station = flying({ autopilot_hil: true });
    await press("X-Plane", "Manual");
    await userEvent.setup().click(screen.getByRole("button", { name: "Llevar a mano" }));
    expect(newest(station)).toMatchObject({ method: "PUT", path: "/api/v1/hil", body: { path: "manual" } });
  });

  test("asks although the heartbeat is old: nobody said that the autopilot is off", async () => {
    const station = flying({ autopilot_hil: true });
    station.pass(700);
    station.status(aStatus());
    await press("X-Plane", "Manual");
    expect(screen.getByRole("alertdialog")).toBeDefined();
  });
});

describe("with RC as source", () => {
  test("the transmitter's flags are shown, and its switch decides", async () => {
    const station = flying({ source_joystick: false, autopilot: true });
    expect(position("Autopilot")).toBe("on");
    const on = within(control("Autopilot")).getByRole("radio", { name: "On" });
    expect(on.getAttribute("aria-disabled")).toBe("true");
    expect(within(control("Autopilot")).getByText(/manda el interruptor del transmisor/)).toBeTruthy();
    await press("Autopilot", "On");
    expect(station.asked).toEqual([]);
    station.show();
    expect(lastMessage()).toContain("No se ha hecho nada. Con RC como fuente manda");
  });

  test("the source can be changed back", async () => {
    const station = flying({ source_joystick: false });
    await press("Fuente", "Joystick");
    expect(newest(station)).toMatchObject({ path: "/api/v1/hil", body: { source: "joystick" } });
  });
});

describe("Autopilot Off and Manual are asked for at every press", () => {
  const without = { ...aStatus().board, state: "closed", url: null, mode: null } as const;

  test.each([
    ["without a board", (station: Station) => station.status(aStatus({ board: without }))],
    ["as a viewer", (station: Station) => station.status(aStatus({ control: heldBy("c2", "Ana") }))],
    ["while the station is silent", (station: Station) => station.pass(1400)],
    ["while the line to the station is broken", (station: Station) => station.breakOff()],
    ["where the switches stand there already", (station: Station) => flyByHand(station)],
    [
      "with RC as source",
      (station: Station) => station.send({ heartbeat: { ...heartbeat, source_joystick: false } }),
    ],
  ])("%s", async (_when, happens) => {
    const station = flying();
    happens(station);
    await press("Autopilot", "Off");
    await press("X-Plane", "Manual");
    expect(station.asked.map(({ path }) => path)).toEqual(["/api/v1/commands/autopilot_off", "/api/v1/hil"]);
    await station.asked[0]?.answer({ code: "control_held", detail: "", params: { name: "Ana" } }, 409);
    expect(lastMessage()).toContain("El control lo tiene Ana");
  });

  test("in the past they are answered: nothing of it goes to the board", async () => {
    const station = flying();
    station.openFlight("20260131T120000Z", 10);
    const before = station.asked.length;
    await press("Autopilot", "Off");
    await act(async () => undefined);
    station.show();
    expect(station.asked.slice(before).filter(({ method }) => method !== "GET")).toEqual([]);
    expect(lastMessage()).toContain("pasado");
  });

  function flyByHand(station: Station): void {
    station.status(aStatus({ hil: { ...aStatus().hil, path: "manual" } }));
    expect([position("Autopilot"), position("X-Plane")]).toEqual(["off", "manual"]);
  }
});

describe("a control that cannot be used says why", () => {
  test("without a board", async () => {
    const station = new Station();
    station.greet(aStatus({ board: { ...aStatus().board, state: "closed", url: null, mode: null } }));
    station.show();
    expect(within(control("Autopilot")).getByText("No hay enlace con la placa.")).toBeTruthy();
    await press("Autopilot", "On");
    expect(station.asked).toEqual([]);
    station.show();
    expect(lastMessage()).toContain("No se ha hecho nada. No hay enlace con la placa.");
  });

  test("as a viewer", () => {
    const station = new Station();
    station.greet(aStatus({ control: heldBy("c2", "Ana") }));
    expect(within(control("X-Plane")).getByText("Espectador: el control lo tiene Ana.")).toBeTruthy();
    expect(screen.queryByRole("button", { name: "Tomar el control" })).toBeNull();
    expect(screen.getByRole("button", { name: "Pedir el control" }).getAttribute("aria-disabled")).toBeNull();
  });
});

test("control is given back and taken again", async () => {
  const station = flying();
  await userEvent.setup().click(screen.getByRole("button", { name: "Soltar" }));
  expect(newest(station)).toMatchObject({
    path: "/api/v1/control",
    body: { client: "c1", action: "release" },
  });
  await newest(station).answer({ client: null, name: null });
  station.status(aStatus({ control: heldBy(null, null) }));
  await userEvent.setup().click(screen.getByRole("button", { name: "Tomar el control" }));
  expect(newest(station)).toMatchObject({ body: { client: "c1", action: "take" } });
});

test("another browser's command is told, with its outcome", () => {
  const station = flying();
  station.deliver({
    type: "event",
    event: "command",
    t_s: 1,
    data: {
      id: 3,
      name: "autopilot_off",
      value: [],
      client: "c9",
      state: "confirmed",
      by: "heartbeat",
      ms: 80,
      reason: null,
    },
  });
  expect(lastMessage()).toContain("Autopilot Off: confirmado por el latido en 80 ms.");
});
