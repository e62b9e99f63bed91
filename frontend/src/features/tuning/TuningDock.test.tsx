import { screen, within } from "@testing-library/react";
import { describe, expect, test } from "vitest";
import { PARAMETERS } from "../../protocol/messages.gen";
import { type GainStates, openPage, row, station, user, writes } from "../../test/params";

const PITCH = PARAMETERS.find(({ name }) => name === "k_pitch")?.default ?? null;

describe("the tuning view", () => {
  const dock = () => screen.getByRole("region", { name: "Ajuste" });

  test("shows the gains of a loop beside its signals, and stays open under another tab", async () => {
    await openPage();
    await user.click(within(row("k_roll")).getByRole("button", { name: "Ajustar k_roll con gráfica" }));
    station.show();
    expect(within(dock()).getByRole("figure", { name: "Señales del lazo Roll" }).textContent).toContain(
      "Aileron",
    );
    await user.click(screen.getByRole("tab", { name: "Setup" }));
    const input = within(dock()).getByRole("textbox", { name: "k_roll" });
    await user.clear(input);
    await user.type(input, "3{Enter}");
    expect(writes()).toEqual([{ k_roll: 3 }]);
  });

  test("marks each change of a gain in the plot, and nothing when a gain becomes known", async () => {
    await openPage();
    await user.click(within(row("k_roll")).getByRole("button", { name: "Ajustar k_roll con gráfica" }));
    station.show();
    const told = () => within(dock()).getByRole("figure").textContent;
    const tell = (parameters: GainStates): void =>
      station.deliver({ type: "event", event: "parameter", t_s: 1, data: { parameters } });
    const held = { loaded: 2, state: "confirmed" } as const;
    tell({ k_roll: { ...held, value: 2.5 } });
    station.pass(2000);
    expect(told()).toContain("→ 2.5, hace");
    tell({ k_pitch: { value: null, loaded: null, state: "unknown" } });
    const count = told()?.split("→").length;
    tell({ k_pitch: { ...held, value: PITCH } });
    station.pass(2000);
    expect(told()?.split("→").length).toBe(count);
  });

  test("draws the roll that the autopilot asks for, by its law and the gain that the board has", async () => {
    await openPage();
    await user.click(within(row("k_roll")).getByRole("button", { name: "Ajustar k_roll con gráfica" }));
    station.send({
      heartbeat: { autopilot_hil: true },
      fms_hil_plan: { bearing_deg: 100, distance_m: 5000, speed_kt: 50 },
      simulator: { horizontal_path_deg: 90, roll_deg: 3 },
    });
    expect(within(dock()).getByRole("figure").textContent).toContain("Roll pedido8.0000°");
  });

  test("can show another loop, and be closed", async () => {
    await openPage();
    await user.click(within(row("k_roll")).getByRole("button", { name: "Ajustar k_roll con gráfica" }));
    await user.selectOptions(within(dock()).getByRole("combobox", { name: "Lazo" }), "altitude");
    expect(within(dock()).getByRole("textbox", { name: "k_altura" })).toBeDefined();
    await user.click(within(dock()).getByRole("button", { name: "Cerrar el ajuste" }));
    expect(screen.queryByRole("region", { name: "Ajuste" })).toBeNull();
  });
});
