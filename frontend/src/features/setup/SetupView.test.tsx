import { screen, within } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { beforeEach, describe, expect, test } from "vitest";
import { aStatus } from "../../test/aStatus";
import { type FakeRequest, Station } from "../../test/station";
import { Tab } from "../../test/tab";

let station: Station;
const user = userEvent.setup();
const closed = aStatus({
  board: { ...aStatus().board, state: "closed", url: null, mode: null, firmware: null },
  simulator: { ...aStatus().simulator, state: "closed" },
});

function board(): HTMLElement {
  return screen.getByRole("region", { name: "Comunicación con el Piloto Automático" });
}

function simulator(): HTMLElement {
  return screen.getByRole("region", { name: "XPlane" });
}

function newest(method: string): FakeRequest {
  const asked = station.asked
    .filter((question) => question.method === method && /^\/api\/v1\/(links|ports)/.test(question.path))
    .at(-1);
  if (asked === undefined) {
    throw new Error(`the page asked nothing with ${method}`);
  }
  return asked;
}

beforeEach(async () => {
  station = new Station(<Tab name="setup" />);
  station.greet(closed);
  const port = { path: "/dev/ttyUSB0", url: "serial:///dev/ttyUSB0", description: "FT232R", identity: null };
  await newest("GET").answer({ ports: [port] });
});

describe("the board's line", () => {
  test("is opened at the chosen port and speed", async () => {
    await user.selectOptions(within(board()).getByRole("combobox", { name: "Puerto" }), "/dev/ttyUSB0");
    await user.selectOptions(within(board()).getByRole("combobox", { name: "Velocidad" }), "57600");
    await user.click(within(board()).getByRole("button", { name: /Open/ }));
    expect(newest("PUT")).toMatchObject({
      path: "/api/v1/links/board",
      body: { url: "serial:///dev/ttyUSB0?baud=57600" },
    });
  });

  test("is opened at a written address", async () => {
    await user.selectOptions(within(board()).getByRole("combobox", { name: "Puerto" }), "other");
    await user.type(
      within(board()).getByRole("textbox", { name: "Dirección" }),
      "tcp://127.0.0.1:5760{Enter}",
    );
    await user.click(within(board()).getByRole("button", { name: /Open/ }));
    expect(newest("PUT").body).toEqual({ url: "tcp://127.0.0.1:5760" });
  });

  test("that cannot be opened says which, why and what to do, in the page's language", async () => {
    await user.selectOptions(within(board()).getByRole("combobox", { name: "Puerto" }), "/dev/ttyUSB0");
    await user.click(within(board()).getByRole("button", { name: /Open/ }));
    await newest("PUT").answer(
      { code: "link_busy", detail: "It is in use.", params: { target: "/dev/ttyUSB0" } },
      409,
    );
    expect(within(board()).getByRole("alert").textContent).toBe(
      "/dev/ttyUSB0 lo está usando otro programa: ciérralo y vuelve a abrir.",
    );
  });

  test("with a problem that this page does not know shows the gateway's own sentence", async () => {
    await user.selectOptions(within(board()).getByRole("combobox", { name: "Puerto" }), "/dev/ttyUSB0");
    await user.click(within(board()).getByRole("button", { name: /Open/ }));
    await newest("PUT").answer({ code: "new_code", detail: "The moon is in the way.", params: {} }, 409);
    expect(within(board()).getByRole("alert").textContent).toBe("The moon is in the way.");
  });

  test("that was lost says so for as long as it is", () => {
    const failure = {
      code: "link_lost",
      detail: "Lost.",
      params: { target: "/dev/ttyUSB0", reason: "gone" },
    };
    station.status({ ...closed, board: { ...closed.board, state: "lost", failure } });
    expect(within(board()).getByRole("alert").textContent).toContain(
      "Se ha perdido la línea con /dev/ttyUSB0",
    );
    station.status(aStatus());
    expect(within(board()).queryByRole("alert")).toBeNull();
  });

  test("cannot be closed while it is closed, and says why", async () => {
    await user.click(within(board()).getByRole("button", { name: "Close" }));
    expect(station.asked.some(({ method }) => method === "DELETE")).toBe(false);
    station.status(aStatus());
    await user.click(within(board()).getByRole("button", { name: "Close" }));
    expect(newest("DELETE").path).toBe("/api/v1/links/board");
  });
});

test("the ports are read again on demand, and a failure to read them is said", async () => {
  await user.click(within(board()).getByRole("button", { name: /Actualizar/ }));
  await newest("GET").answer("<html>", 502);
  expect(within(board()).getByRole("alert").textContent).toContain("502");
});

describe("the simulator's line", () => {
  test("is opened with the fields as they stand", async () => {
    const host = within(simulator()).getByRole("textbox", { name: "IP XPlane" });
    await user.clear(host);
    await user.type(host, "192.168.1.9");
    await user.click(within(simulator()).getByRole("button", { name: /Open/ }));
    expect(newest("PUT")).toMatchObject({
      path: "/api/v1/links/simulator",
      body: { receive_port: 49003, send_host: "192.168.1.9", send_port: 49000, profile: "xp10" },
    });
  });

  test("takes address and profile from an X-Plane that is heard, and has it send its rows by itself", async () => {
    const found = within(simulator()).getByRole("combobox", { name: "X-Plane en la red" });
    expect(found.textContent).toContain("Escuchando");
    station.show();
    const looks = station.asked.filter(({ path }) => path === "/api/v1/simulators");
    const heard = { name: "sim-pc", host: "192.168.1.9", port: 49010, version: "12.14", profile: "xp12" };
    await looks.at(-1)?.answer({ simulators: [heard] });
    await user.selectOptions(found, "sim-pc · X-Plane 12.14 · 192.168.1.9");
    await user.click(within(simulator()).getByRole("button", { name: /Open/ }));
    expect(newest("PUT").body).toEqual({
      receive_port: 49003,
      send_host: "192.168.1.9",
      send_port: 49010,
      profile: "xp12",
      tells_rows: true,
    });
  });

  test("says that no X-Plane is heard, and looks again", async () => {
    station.show();
    const looks = () => station.asked.filter(({ path }) => path === "/api/v1/simulators");
    await looks().at(-1)?.answer({ simulators: [] });
    expect(simulator().textContent).toContain("No se oye ninguno");
    const asked = looks().length;
    station.pass(2_100);
    station.show();
    expect(looks().length).toBe(asked + 1);
  });

  test("whose port is taken says so", () => {
    const failure = { code: "port_taken", detail: "Taken.", params: { target: "UDP 49003" } };
    station.status({ ...closed, simulator: { ...closed.simulator, state: "lost", failure } });
    expect(within(simulator()).getByRole("alert").textContent).toContain("UDP 49003 lo tiene otro programa");
  });

  test("names the rows that came and those that are missing", () => {
    station.status(
      aStatus({ simulator: { ...aStatus().simulator, rows: [3, 4, 8], missing_rows: [16, 17] } }),
    );
    expect(simulator().textContent).toContain("3, 4, 8");
    expect(simulator().textContent).toContain("Faltan las filas 16, 17");
  });

  test("names the row and the value that the board cannot use", () => {
    const unusable = [{ row: 16, row_name: "angular_velocities", name: "p_rad_s", value: "nan" }];
    station.status(aStatus({ simulator: { ...aStatus().simulator, unusable } }));
    expect(simulator().textContent).toContain(
      "En la fila 16 (Velocidades angulares) el X-Plane envía nan como p_rad_s",
    );
  });

  test("offers the profile that the rows are of, and opens the same link with it", async () => {
    station.status(aStatus());
    expect(within(simulator()).queryByRole("button", { name: /Usar/ })).toBeNull();
    const status = aStatus({ simulator: { ...aStatus().simulator, fitting_profile: "xp12" } });
    station.status(status);
    expect(within(simulator()).getByRole("alert").textContent).toContain(
      "El X-Plane envía las filas de X-Plane 12",
    );
    await user.click(within(simulator()).getByRole("button", { name: "Usar X-Plane 12" }));
    expect(newest("PUT")).toMatchObject({
      path: "/api/v1/links/simulator",
      body: { receive_port: 49003, send_host: "127.0.0.1", send_port: 49000, profile: "xp12" },
    });
    expect(within(simulator()).getByRole("combobox", { name: "Perfil" })).toHaveProperty("value", "xp12");
    station.status(aStatus({ simulator: { ...status.simulator, profile: "xp12", fitting_profile: null } }));
    expect(within(simulator()).queryByRole("alert")).toBeNull();
  });
});
