import { screen, within } from "@testing-library/react";
import { describe, expect, test } from "vitest";
import { openPage, row, station, user, writes } from "../../test/params";

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

  test("can show another loop, and be closed", async () => {
    await openPage();
    await user.click(within(row("k_roll")).getByRole("button", { name: "Ajustar k_roll con gráfica" }));
    await user.selectOptions(within(dock()).getByRole("combobox", { name: "Lazo" }), "altitude");
    expect(within(dock()).getByRole("textbox", { name: "k_altura" })).toBeDefined();
    await user.click(within(dock()).getByRole("button", { name: "Cerrar el ajuste" }));
    expect(screen.queryByRole("region", { name: "Ajuste" })).toBeNull();
  });
});
