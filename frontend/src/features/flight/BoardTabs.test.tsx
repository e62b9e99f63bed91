import { fireEvent, screen, within } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { beforeEach, describe, expect, test } from "vitest";
import { aStatus, heldBy } from "../../test/aStatus";
import { Station } from "../../test/station";
import { Tab } from "../../test/tab";

const CONFIRMED = { state: "confirmed", by: "acknowledgement", ms: 9, reason: null };
const user = userEvent.setup();
let station: Station;

beforeEach(() => {
  station = new Station(<Tab name="flight" />);
  station.greet();
});

async function open(name: string): Promise<HTMLElement> {
  await user.click(screen.getByRole("tab", { name }));
  station.show();
  return screen.getByRole("tabpanel", { name });
}

function slider(number: number): HTMLInputElement {
  return screen.getByRole<HTMLInputElement>("slider", { name: `Servo ${number}` });
}

describe("ServosOut", () => {
  beforeEach(() => open("ServosOut"));

  test("has twenty upright sliders from -1 to +1 which know no position and send nothing by being shown", () => {
    const sliders = screen.getAllByRole<HTMLInputElement>("slider");
    expect(sliders).toHaveLength(20);
    for (const each of sliders) {
      expect([each.min, each.max, each.getAttribute("aria-orientation")]).toEqual(["-1", "1", "vertical"]);
      expect(each.getAttribute("aria-valuetext")).toContain("sin mover");
    }
    expect(station.asked).toEqual([]);
  });

  test("sends a move at once and shows what became of it", async () => {
    fireEvent.change(slider(3), { target: { value: "0.5" } });
    expect(station.asked[0]).toMatchObject({
      method: "POST",
      path: "/api/v1/commands/servo_out",
      body: { value: { servo: 2, position: 0.5 } },
    });
    expect(slider(3).getAttribute("aria-valuetext")).toBe("0.50");
    expect(slider(3).getAttribute("aria-describedby")).not.toBeNull();
    await station.asked[0]?.answer(CONFIRMED);
    expect(slider(3).closest(".ui-vslider")?.getAttribute("data-state")).toBe("confirmed");
  });

  test("centres one servo, and all, at the line's pace", async () => {
    await user.click(screen.getByRole("button", { name: "Centrar el servo 5" }));
    expect(station.asked[0]?.body).toEqual({ value: { servo: 4, position: 0 } });
    await station.asked[0]?.answer(CONFIRMED);
    await user.click(screen.getByRole("button", { name: "Centrar todos" }));
    station.pass(2000);
    expect(station.asked).toHaveLength(21);
  });

  test("cannot be moved by a viewer, and says why", () => {
    station.status(aStatus({ control: heldBy("c2", "Ana") }));
    fireEvent.change(slider(1), { target: { value: "0.5" } });
    expect(station.asked).toEqual([]);
    expect(slider(1).getAttribute("aria-disabled")).toBe("true");
    const reason = document.getElementById(slider(1).getAttribute("aria-describedby") ?? "");
    expect(reason?.textContent).toContain("Ana");
  });

  test("says why a move was refused", async () => {
    fireEvent.change(slider(1), { target: { value: "0.5" } });
    await station.asked[0]?.answer({ code: "board_not_open", detail: "No.", params: {} }, 409);
    const panel = screen.getByRole("tabpanel", { name: "ServosOut" });
    expect(within(panel).getByRole("alert").textContent).toContain("no hay ninguna placa");
  });

  test("tells what drives the servos, as the board says", () => {
    const panel = screen.getByRole("tabpanel", { name: "ServosOut" });
    expect(panel.textContent).toContain("Modo de la placa: desconocido");
    station.send({ board_status: { servos_control_mode: 1 } });
    expect(panel.textContent).toContain("Modo de la placa: HIL");
  });
});

describe("Refresco", () => {
  function field(name: string): HTMLInputElement {
    return screen.getByRole<HTMLInputElement>("textbox", { name });
  }

  test("shows the periods in force, with who chose them", async () => {
    const { board } = aStatus();
    const chosen = { ...board.periods_ms, fms: { ms: 250, chosen: true } };
    station.status(aStatus({ board: { ...board, periods_ms: chosen } }));
    const tab = await open("Refresco");
    expect(["Parámetros", "FMS", "Servos"].map((name) => field(name).value)).toEqual(["100", "250", "20"]);
    expect(tab.textContent?.match(/Elegido desde esta estación/g)).toHaveLength(1);
    expect(tab.textContent).toContain("De 50 a 10000 ms; por defecto 100.");
    expect(station.asked).toEqual([]);
  });

  test("sends a period once it is finished, and not for each key", async () => {
    await open("Refresco");
    await user.clear(field("FMS"));
    await user.type(field("FMS"), "250");
    expect(station.asked).toEqual([]);
    await user.keyboard("{Enter}");
    expect(station.asked).toHaveLength(1);
    expect(station.asked[0]).toMatchObject({
      path: "/api/v1/commands/set_fms_task_rate",
      body: { value: 250 },
    });
  });

  test("sends nothing that is out of range or taken back", async () => {
    await open("Refresco");
    await user.clear(field("Servos"));
    await user.type(field("Servos"), "5{Enter}");
    await user.keyboard("{Escape}");
    await user.tab();
    expect(station.asked).toEqual([]);
    expect(field("Servos").value).toBe("20");
  });

  test("knows no period of a board that is not there", async () => {
    station.status(aStatus({ board: { ...aStatus().board, state: "lost" } }));
    const tab = await open("Refresco");
    expect(field("Parámetros").value).toBe("");
    expect(tab.textContent).toContain("La placa no está conectada.");
  });
});
