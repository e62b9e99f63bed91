import { act, screen, waitFor, within } from "@testing-library/react";
import { describe, expect, test } from "vitest";
import { listed, newest, open, row, station, user, writes } from "../../test/params";

describe("a change of several", () => {
  const dialog = () => screen.getByRole("dialog");

  test("to the defaults shows the difference and asks, then tells each result", async () => {
    await open({ k_roll: { value: 2.5 }, k_pitch: { value: 3 } });
    await user.click(screen.getByRole("button", { name: "Valores por defecto" }));
    expect(writes()).toEqual([]);
    await user.click(within(dialog()).getByRole("checkbox", { name: "Escribir k_pitch" }));
    await user.click(within(dialog()).getByRole("button", { name: "Escribir 1 en la placa" }));
    expect(writes()).toEqual([{ k_roll: 2 }]);
    expect(within(dialog()).getByText("w-pending")).toBeDefined();
    await newest("PATCH", /parameters$/).answer(listed({ k_roll: { value: 2.5, state: "rejected" } }));
    expect(within(dialog()).getByText("rechazado: la relectura da 2.5")).toBeDefined();
  });

  test("of one to its default writes that one", async () => {
    await open({ k_roll: { value: 2.5 }, k_pitch: { value: 3 } });
    await user.click(within(row("k_roll")).getByRole("button", { name: /valor por defecto/ }));
    await user.click(within(dialog()).getByRole("button", { name: "Escribir 1 en la placa" }));
    expect(writes()).toEqual([{ k_roll: 2 }]);
  });

  test("can be left without a write", async () => {
    await open({ k_roll: { value: 2.5 } });
    await user.click(screen.getByRole("button", { name: "Valores por defecto" }));
    await user.click(within(dialog()).getByRole("button", { name: "Cancelar" }));
    expect(screen.queryByRole("dialog")).toBeNull();
    expect(writes()).toEqual([]);
  });

  async function choose(text: string, name = "gains.json"): Promise<void> {
    const input = document.querySelector<HTMLInputElement>('.params-tools input[type="file"]');
    if (input === null) throw new Error("there is no field for a file");
    await act(() => user.upload(input, new File([text], name, { type: "application/json" })));
  }
  const file = (lines: string) => `{"format":"epf-gcs-parameters","version":1,"parameters":[${lines}]}`;

  test("out of a file is ticked line by line; what is wrong in it cannot be", async () => {
    await open();
    await choose(
      file(
        '{"name":"k_roll","value":2.5},{"name":"k_pitch","value":NaN},{"name":"k_flap","value":1},{"name":"k_elev","value":1}',
      ),
    );
    await waitFor(dialog);
    const boxes = within(dialog()).getAllByRole<HTMLInputElement>("checkbox");
    expect(boxes.map((box) => [box.getAttribute("aria-label"), box.checked])).toEqual([
      ["Escribir k_roll", false],
    ]);
    expect(dialog().textContent).toContain("NaN no es un número");
    expect(dialog().textContent).toContain("parámetro desconocido");
    expect(writes()).toEqual([]);
    await user.click(boxes[0] ?? dialog());
    await user.click(within(dialog()).getByRole("button", { name: "Escribir 1 en la placa" }));
    expect(writes()).toEqual([{ k_roll: 2.5 }]);
    await newest("PATCH", /parameters$/).answer(listed({ k_roll: { value: 2.5, state: "confirmed" } }));
    expect(within(dialog()).getByText("confirmado")).toBeDefined();
  });

  test("out of a file that is none says so and opens nothing", async () => {
    await open();
    await choose("k_roll = 2", "notes.json");
    expect((await screen.findByRole("alert")).textContent).toContain(
      "notes.json no es un archivo JSON entero",
    );
    expect(screen.queryByRole("dialog")).toBeNull();
  });

  test("a saved file holds what the board has and says which board", async () => {
    await open({ k_roll: { value: 2.5 } });
    await user.click(screen.getByRole("button", { name: "Guardar en archivo" }));
    const [saved] = station.saved;
    expect(saved?.name).toMatch(/^epf-parameters-\d{8}-\d{6}\.json$/);
    const text = JSON.parse((await saved?.content.text()) ?? "");
    expect(text).toMatchObject({ format: "epf-gcs-parameters", board: { name: "epf", version: "1.0" } });
    expect(text.parameters).toContainEqual({ name: "k_roll", value: 2.5 });
    expect(writes()).toEqual([]);
  });
});
