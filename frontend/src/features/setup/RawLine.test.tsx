import { screen, within } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { beforeEach, describe, expect, test, vi } from "vitest";
import { aStatus } from "../../test/aStatus";
import { Station } from "../../test/station";
import { Tab } from "../../test/tab";
import { CONSOLE_LINES } from "./consoleLog";

let station: Station;
const user = userEvent.setup();

beforeEach(async () => {
  station = new Station(<Tab name="setup" />);
  station.greet();
  station.show();
});

function line(): HTMLElement {
  return screen.getByRole("textbox", { name: "Línea para la placa" });
}

function log(): HTMLElement {
  return screen.getByRole("log");
}

function posts() {
  return station.asked.filter(({ method }) => method === "POST");
}

function comes(text: string, direction = "received"): void {
  station.deliver({ type: "event", event: "console", t_s: 1, data: { direction, text } });
}

describe("the raw line", () => {
  test("goes out on Enter, and the field is free for the next", async () => {
    await user.type(line(), "#QT help");
    expect(posts()).toEqual([]);
    await user.keyboard("{Enter}");
    expect(posts()[0]).toMatchObject({ path: "/api/v1/console", body: { text: "#QT help" } });
    await posts()[0]?.answer({ text: "#QT help" });
    expect(line()).toHaveProperty("value", "");
  });

  test("goes out by its button, once", async () => {
    await user.type(line(), "ver");
    await user.click(screen.getByRole("button", { name: "Enviar" }));
    expect(posts()).toHaveLength(1);
  });

  test("that did not go out stays, with the reason", async () => {
    await user.type(line(), "ver{Enter}");
    await posts()[0]?.answer({ code: "board_not_open", detail: "No.", params: {} }, 409);
    expect(line()).toHaveProperty("value", "ver");
    const panel = screen.getByRole("region", { name: /^Envío y recepción/ });
    expect(within(panel).getByRole("alert").textContent).toContain("no hay ninguna placa");
  });

  test("that the board's shell cannot take is not sent, and says why", async () => {
    await user.type(line(), "año{Enter}");
    expect(posts()).toEqual([]);
    expect(line().getAttribute("aria-invalid")).toBe("true");
  });

  test("is closed while no line stands", () => {
    station.status(aStatus({ board: { ...aStatus().board, state: "closed" } }));
    expect(line().getAttribute("aria-disabled")).toBe("true");
  });
});

describe("what went over the line", () => {
  test("stands with its direction, whoever sent it", () => {
    comes("ver", "sent");
    comes("epf 1.0");
    const said = [...log().querySelectorAll("p")].map((entry) => entry.textContent);
    expect(said[0]).toContain("enviado:ver");
    expect(said[1]).toContain("recibido:epf 1.0");
  });

  test("is bounded, and says that older lines are gone", () => {
    for (let number = 0; number < CONSOLE_LINES + 5; number += 1) {
      comes(`line ${number}`);
    }
    expect(log().querySelectorAll("p")).toHaveLength(CONSOLE_LINES + 1);
    expect(log().textContent).toContain("5 líneas más antiguas");
    expect(log().textContent).toContain(`line ${CONSOLE_LINES + 4}`);
  });

  test("can be copied and cleared", async () => {
    const written = vi.spyOn(navigator.clipboard, "writeText");
    comes("epf 1.0");
    await user.click(screen.getByRole("button", { name: "Copiar" }));
    expect(written).toHaveBeenCalledWith(expect.stringMatching(/^\d\d:\d\d:\d\d ← epf 1\.0$/));
    await user.click(screen.getByRole("button", { name: "Limpiar" }));
    station.show();
    expect(log().textContent).toBe("Todavía no se ha enviado ni recibido texto.");
  });
});

describe("the table of rows", () => {
  function cells(row: number): string[] {
    const table = screen.getByRole("table");
    const head = within(table).getByRole("rowheader", { name: String(row) });
    return [...(head.closest("tr")?.querySelectorAll("td") ?? [])].map((cell) => cell.textContent ?? "");
  }

  test("is empty until a row comes", () => {
    expect(screen.getByText("Todavía no ha llegado ninguna trama.")).toBeTruthy();
  });

  test("shows every row that comes, known or not, with what is absent as no data", () => {
    station.rows({
      20: [27.9515331, -15.3741, -999, null, 0, 1, 2, 3],
      99: [1, 2, 3, 4, 5, 6, 7, 8],
    });
    station.show();
    expect(cells(20).slice(0, 5)).toEqual(["Posición", "27.95153", "-15.37410", "–", "–"]);
    expect(cells(99)[0]).toBe("–");
    expect(screen.getByRole("heading", { name: "Tramas de X-Plane: #2" })).toBeTruthy();
  });

  test("does not leave a row that no longer comes looking live", () => {
    station.rows({ 3: [55], 4: [0.1] });
    for (let tenth = 0; tenth < 20; tenth += 1) {
      station.rows({ 4: [0.1] });
    }
    expect(cells(3)[1]).toBe("–");
    expect(cells(4)[1]).toBe("0.100000");
    expect(cells(3)[9]).toMatch(/^[12]\.\d s$/);
    expect(screen.getByRole("heading", { name: "Tramas de X-Plane: #1" })).toBeTruthy();
  });
});
