import { screen, within } from "@testing-library/react";
import { describe, expect, test } from "vitest";
import { aStatus, heldBy } from "../../test/aStatus";
import {
  answer,
  field,
  listed,
  newest,
  open,
  openUnanswered,
  row,
  station,
  type,
  unknown,
  user,
  writes,
} from "../../test/params";

describe("the gains as the board has them", () => {
  test("are shown by group, with default, range, step and unit", async () => {
    await open({ k_roll: { value: 2.5 } });
    const group = screen.getByRole("region", { name: "Control de rumbo" });
    expect(
      within(group)
        .getAllByRole("textbox")
        .map(({ id }) => document.querySelector(`label[for="${id}"]`)?.textContent),
    ).toEqual(["k_airln", "k_div_P_init", "k_div_P_speed", "k_roll", "k_heading"]);
    expect(field("k_roll").value).toBe("2.5");
    expect(row("k_roll").textContent).toContain("def. 2 · 0…99.99 · paso 0.1");
    expect(row("k_roll").textContent).toContain("1/rad");
  });

  test("are asked of the gateway alone: opening the tab sends nothing to the board", async () => {
    await open();
    expect(station.asked.map(({ method, path }) => `${method} ${path}`)).toEqual([
      "GET /api/v1/parameters",
      "GET /api/v1/parameters/journal",
    ]);
  });

  test("are unknown before a load, and look it", async () => {
    await open(unknown);
    expect(field("k_roll").value).toBe("");
    expect(field("k_roll").placeholder).not.toMatch(/\d/);
    expect(screen.getByText(/todavía no se han leído/)).toBeDefined();
    await user.click(screen.getByRole("button", { name: "Guardar en archivo" }));
    expect(station.saved).toEqual([]);
  });

  test("are unknown again when the board is lost", async () => {
    await open();
    station.deliver({ type: "event", event: "parameter", t_s: 1, data: { parameters: unknown } });
    expect(field("k_roll").value).toBe("");
  });

  test("are unknown again when the gateway is lost", async () => {
    await open();
    station.breakOff();
    expect(field("k_roll").value).toBe("");
  });

  test("follow what another station writes", async () => {
    await open();
    const k_roll = { value: 3, loaded: 2, state: "confirmed" };
    station.deliver({ type: "event", event: "parameter", t_s: 1, data: { parameters: { k_roll } } });
    expect(field("k_roll").value).toBe("3");
  });
});

describe("a load", () => {
  test("keeps what it read when an earlier question is answered after it", async () => {
    openUnanswered();
    await user.click(screen.getByRole("button", { name: "Load" }));
    await newest("POST", /load$/).answer(listed({ k_roll: { value: 2.25, loaded: 2.25 } }));
    await answer(unknown);
    expect(field("k_roll").value).toBe("2.25");
    await answer({ k_roll: { value: 2.25, loaded: 2.25 } });
    expect(field("k_roll").value).toBe("2.25");
  });

  test("only reads", async () => {
    await open(unknown);
    await user.click(screen.getByRole("button", { name: "Load" }));
    expect(writes()).toEqual(["/api/v1/parameters/load"]);
    await newest("POST", /load$/).answer(listed({ k_roll: { value: 2.25, loaded: 2.25 } }));
    expect(field("k_roll").value).toBe("2.25");
  });
});

describe("an edit", () => {
  test("goes out once, on Enter, and is confirmed by what was read back", async () => {
    await open();
    await type("k_roll", "2.5");
    expect(writes()).toEqual([]);
    await user.keyboard("{Enter}");
    await user.tab();
    expect(writes()).toEqual([{ k_roll: 2.5 }]);
    expect(within(row("k_roll")).getByText("w-pending")).toBeDefined();
    await newest("PATCH", /parameters$/).answer(listed({ k_roll: { value: 2.5, state: "confirmed" } }));
    expect(within(row("k_roll")).getByText("k_roll = 2.5: confirmado por relectura.")).toBeDefined();
    expect(field("k_roll").value).toBe("2.5");
  });

  test("that the board refused shows what the board has, and says so", async () => {
    await open();
    await type("k_roll", "2.5{Enter}");
    await newest("PATCH", /parameters$/).answer(listed({ k_roll: { state: "rejected" } }));
    expect(field("k_roll").value).toBe("2");
    // The refusal of the question is shown for ten seconds; that of the gain, for as long as it is refused.
    for (let round = 0; round < 40; round += 1) {
      station.pass(300);
      station.status(aStatus());
    }
    expect(row("k_roll").textContent).toContain("la relectura da 2");
  });

  test("out of range, or not whole where it must be, is refused here", async () => {
    await open();
    await type("k_roll", "100{Enter}");
    expect(row("k_roll").textContent).toContain("w-outside 0 to 99.99");
    await type("k_div_velocidad", "700.5{Enter}");
    expect(row("k_div_velocidad").textContent).toContain("número entero");
    expect(writes()).toEqual([]);
  });

  test("while the last one is under way waits, and only the newest goes out", async () => {
    await open();
    const up = within(row("k_roll")).getByRole("button", { name: "w-increase k_roll" });
    await user.click(up);
    await user.click(up);
    await user.click(up);
    expect(writes()).toEqual([{ k_roll: 2.1 }]);
    await newest("PATCH", /parameters$/).answer(listed({ k_roll: { value: 2.1, state: "confirmed" } }));
    expect(writes()).toEqual([{ k_roll: 2.1 }, { k_roll: 2.3 }]);
  });

  test("cannot be made by a viewer, who is told why", async () => {
    await open({}, aStatus({ control: heldBy("c2", "Ana") }));
    expect(screen.getByRole("textbox", { name: "k_roll", description: /Ana/ })).toBeDefined();
    await user.type(field("k_roll"), "3{Enter}");
    expect(writes()).toEqual([]);
  });
});

describe("marks", () => {
  test("tell what is other than the default, and what changed since the load", async () => {
    await open({ k_roll: { value: 2.5, loaded: 2.5 }, k_pitch: { value: 2, loaded: 1.5 } });
    expect(row("k_roll").textContent).toContain("Distinto del valor por defecto, 2.");
    expect(row("k_roll").textContent).not.toContain("Distinto del cargado");
    expect(row("k_pitch").textContent).toContain("Distinto del cargado, 1.5.");
    expect(screen.getByText("Distintos del defecto: 1 · cambiados desde la carga: 1")).toBeDefined();
  });

  test("choose what is shown, as the search does, without accents", async () => {
    await open({ k_roll: { value: 2.5, loaded: 2.5 } });
    await user.selectOptions(screen.getByRole("combobox", { name: "Mostrar" }), "default");
    expect(screen.getAllByRole("textbox").map(({ id }) => id).length).toBe(2);
    await user.selectOptions(screen.getByRole("combobox", { name: "Mostrar" }), "all");
    await user.type(screen.getByRole("textbox", { name: "Buscar" }), "guinada");
    expect(document.querySelectorAll("[data-parameter]")).toHaveLength(2);
    await user.type(screen.getByRole("textbox", { name: "Buscar" }), "xyz");
    expect(screen.getByText("Ningún parámetro responde a la búsqueda.")).toBeDefined();
  });
});

describe("store", () => {
  test("is said only when the board has said it, and no longer once a value changes", async () => {
    await open();
    await user.click(screen.getByRole("button", { name: "Store" }));
    expect(screen.queryByText(/Guardado en la tarjeta/)).toBeNull();
    await newest("POST", /store$/).answer({
      state: "confirmed",
      by: "acknowledgement",
      ms: 20,
      reason: null,
    });
    expect(screen.getByText(/Guardado en la tarjeta de la placa a las/)).toBeDefined();
    const k_roll = { value: 3, loaded: 2, state: "confirmed" };
    station.deliver({ type: "event", event: "parameter", t_s: 1, data: { parameters: { k_roll } } });
    expect(screen.queryByText(/Guardado en la tarjeta/)).toBeNull();
  });

  test("that failed says why", async () => {
    await open();
    await user.click(screen.getByRole("button", { name: "Store" }));
    const failed = { state: "rejected", by: "acknowledgement", ms: 20, reason: "storage_failed" };
    await newest("POST", /store$/).answer(failed);
    expect(screen.getByRole("button", { name: "Store", description: /no se pudo guardar/ })).toBeDefined();
    expect(screen.queryByText(/Guardado en la tarjeta/)).toBeNull();
  });

  test("is not offered by a board that cannot", async () => {
    const none = { acknowledgements: false, store: false, sources: false, missions: false };
    await open({}, aStatus({ board: { ...aStatus().board, mode: "legacy", features: none } }));
    await user.click(screen.getByRole("button", { name: "Store", description: /Esta placa no lo admite/ }));
    expect(writes()).toEqual([]);
  });
});

describe("undo", () => {
  const entry = {
    id: 7,
    t_s: 1_700_000_000,
    client: "c1",
    name: "Ana",
    kind: "write",
    state: "confirmed",
    changes: [{ name: "k_roll", before: 2, after: 2.5, state: "confirmed" }],
  };
  const undo = [{ name: "k_roll", before: 2.5, after: 2 }];

  test("says what it would do, and is a write like any other", async () => {
    await open({ k_roll: { value: 2.5 } });
    expect(screen.getByRole("button", { name: "Deshacer", description: /nada que deshacer/ })).toBeDefined();
    station.deliver({ type: "event", event: "journal", t_s: 1, data: { entry, undo, redo: null } });
    await user.click(
      screen.getByRole("button", { name: "Deshacer", description: "Deshacer: k_roll 2.5 → 2" }),
    );
    await newest("POST", /undo$/).answer(listed({ k_roll: { value: 2, state: "confirmed" } }));
    expect(field("k_roll").value).toBe("2");
  });

  test("the journal tells who wrote what, and what became of it", async () => {
    await open();
    const other = { ...entry, id: 8, client: "c9", name: "Ana", state: "rejected", kind: "undo" };
    station.deliver({ type: "event", event: "journal", t_s: 1, data: { entry, undo, redo: null } });
    station.deliver({
      type: "event",
      event: "journal",
      t_s: 1,
      data: { entry: other, undo: null, redo: null },
    });
    const rows = within(screen.getByRole("region", { name: "Diario de cambios" })).getAllByRole("row");
    expect(rows[1]?.textContent).toMatch(/Ana.*deshace.*k_roll 2 → 2\.5.*rechazado/);
    expect(rows[2]?.textContent).toMatch(/esta página.*escribe.*k_roll 2 → 2\.5.*confirmado/);
  });
});
