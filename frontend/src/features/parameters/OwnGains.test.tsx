import { act, screen, waitFor, within } from "@testing-library/react";
import { describe, expect, test } from "vitest";
import type { OwnGainDefinition, OwnGainState, OwnGains } from "../../protocol/guards.gen";
import { aStatus } from "../../test/aStatus";
import {
  answer,
  field,
  listed,
  newest,
  openPage,
  openUnanswered,
  row,
  station,
  type,
  user,
  writes,
} from "../../test/params";

const BANK: OwnGainDefinition = {
  row: 1,
  name: "line_k_bank",
  group: "line_course",
  type: "f32",
  unit: "1/rad",
  minimum: 0.1,
  maximum: 10,
  step: 0.1,
  default: 3,
  choices: [],
  needs_restart: false,
  doc: "Aileron command per rad of bank error.",
};
const LAW: OwnGainDefinition = {
  ...BANK,
  row: 0,
  name: "guidance_law",
  group: "guidance",
  type: "enum",
  unit: "1",
  minimum: 0,
  maximum: 1,
  step: 1,
  default: 0,
  choices: ["deployed", "line"],
  doc: "How plans are flown.",
};
const OF_ANOTHER: OwnGainDefinition = {
  ...BANK,
  row: 2,
  name: "bias",
  group: "my_filter",
  needs_restart: true,
};

function held(value: number | null, change: Partial<OwnGainState> = {}): OwnGainState {
  return {
    value,
    loaded: value,
    state: value === null ? "unknown" : "loaded",
    heard_s: value === null ? null : 1_700_000_000,
    ...change,
  };
}

function described(
  values: Record<string, OwnGainState> = {},
  table: Partial<OwnGains["table"]> = {},
): OwnGains {
  return {
    table: {
      state: "known",
      blocks_read: 3,
      block_count: 3,
      gains: [LAW, BANK, OF_ANOTHER],
      topics: [],
      left_out: [],
      ...table,
    },
    values: { guidance_law: held(0), line_k_bank: held(3), bias: held(null), ...values },
  };
}

async function open(own = described()): Promise<void> {
  openUnanswered();
  await answer({}, own);
}

function choice(): HTMLSelectElement {
  return screen.getByRole("combobox", { name: "guidance_law" });
}

async function choose(text: string): Promise<void> {
  await user.selectOptions(choice(), text);
}

describe("the gains that a board describes itself", () => {
  test("show nothing where the board does not describe itself", async () => {
    openUnanswered();
    await answer({});
    expect(screen.queryByText(/propias/)).toBeNull();
    expect(document.querySelectorAll("[data-parameter]")).toHaveLength(17);
  });

  test("stand in their groups, with unit, range, step, default and the board's words", async () => {
    await open();
    const group = screen.getByRole("region", { name: "Ley de línea: rumbo" });
    expect(within(group).getByRole("textbox", { name: "line_k_bank" })).toBe(field("line_k_bank"));
    expect(row("line_k_bank").textContent).toContain("def. 3 · 0.1…10 · paso 0.1");
    expect(row("line_k_bank").textContent).toContain("1/rad");
    expect(row("line_k_bank").textContent).toContain("Aileron command per rad of bank error.");
    expect(screen.getByRole("region", { name: "my filter" })).toBeDefined();
    expect(row("bias").textContent).toContain("tras el próximo arranque");
  });

  test("look unknown while their value is", async () => {
    await open(described({ guidance_law: held(null) }));
    expect(field("bias").value).toBe("");
    expect(field("bias").placeholder).not.toMatch(/\d/);
    expect(choice().value).toBe("");
    expect(row("guidance_law").textContent).toContain("Valor desconocido");
  });

  test("are written by name and confirmed by what was read back", async () => {
    await open();
    await type("line_k_bank", "3.5{Enter}");
    expect(writes()).toEqual([{ line_k_bank: 3.5 }]);
    const confirmed = described({ line_k_bank: held(3.5, { loaded: 3, state: "confirmed" }) });
    await newest("PATCH", /parameters$/).answer(listed({}, confirmed));
    expect(within(row("line_k_bank")).getByText(/line_k_bank = 3.5: confirmado por relectura/)).toBeDefined();
    expect(row("line_k_bank").textContent).toContain("Distinto del cargado, 3.");
  });

  test("that the board refused show what it has, in words", async () => {
    await open();
    await choose("line");
    const refused = described({ guidance_law: held(0, { state: "rejected" }) });
    await newest("PATCH", /parameters$/).answer(listed({}, refused));
    expect(choice().value).toBe("deployed");
    expect(row("guidance_law").textContent).toMatch(/se pidió line.*la relectura da deployed/i);
  });

  test("are not on the card any more once one changes", async () => {
    await open();
    await user.click(screen.getByRole("button", { name: "Store" }));
    const stored = { state: "confirmed", by: "acknowledgement", ms: 20, reason: null };
    await newest("POST", /store$/).answer(stored);
    expect(screen.getByText(/Guardado en la tarjeta de la placa a las/)).toBeDefined();
    const data = { table: null, values: { line_k_bank: held(5) } };
    station.deliver({ type: "event", event: "own_gains", t_s: 1, data });
    expect(screen.queryByText(/Guardado en la tarjeta/)).toBeNull();
  });

  test("are in a saved file, and taken out of one where the board has them", async () => {
    await open(described({ bias: held(1), guidance_law: held(1) }));
    await user.click(screen.getByRole("button", { name: "Guardar en archivo" }));
    const text = JSON.parse((await station.saved[0]?.content.text()) ?? "");
    expect(text.parameters).toHaveLength(20);
    expect(text.parameters).toContainEqual({ name: "guidance_law", value: 1 });
    const lines = '{"name":"line_k_bank","value":4},{"name":"bias","value":99}';
    const file = `{"format":"epf-gcs-parameters","version":1,"parameters":[${lines}]}`;
    const input = document.querySelector<HTMLInputElement>('.params-tools input[type="file"]');
    if (input === null) throw new Error("there is no field for a file");
    await act(() => user.upload(input, new File([file], "gains.json", { type: "application/json" })));
    await waitFor(() => screen.getByRole("dialog"));
    const dialog = screen.getByRole("dialog");
    expect(dialog.textContent).toContain("99 está fuera de 0.1 … 10");
    await user.click(within(dialog).getByRole("checkbox", { name: "Escribir line_k_bank" }));
    await user.click(within(dialog).getByRole("button", { name: "Escribir 1 en la placa" }));
    expect(writes()).toEqual([{ line_k_bank: 4 }]);
  });

  test("go to their defaults with the others, but for a choice", async () => {
    await open(described({ bias: held(3), guidance_law: held(1), line_k_bank: held(4) }));
    await user.click(screen.getByRole("button", { name: "Valores por defecto" }));
    const dialog = await screen.findByRole("dialog");
    await user.click(within(dialog).getByRole("button", { name: "Escribir 1 en la placa" }));
    expect(writes()).toEqual([{ line_k_bank: 3 }]);
  });

  test("out of range are refused here", async () => {
    await open();
    await type("line_k_bank", "11{Enter}");
    expect(row("line_k_bank").textContent).toContain("w-outside 0.1 to 10");
    expect(writes()).toEqual([]);
  });

  test("follow what the stream tells, and are unknown again when it says so", async () => {
    await open();
    const event = { type: "event", event: "own_gains", t_s: 1 } as const;
    station.deliver({ ...event, data: { table: null, values: { line_k_bank: held(5) } } });
    expect(field("line_k_bank").value).toBe("5");
    const { table } = described({}, { state: "unknown" });
    const values = { guidance_law: held(null), line_k_bank: held(null), bias: held(null) };
    station.deliver({ ...event, data: { table, values } });
    expect(field("line_k_bank").value).toBe("");
    expect(screen.getByText(/su tabla no se ha leído/)).toBeDefined();
    await user.type(field("line_k_bank"), "4{Enter}");
    expect(writes()).toEqual([]);
  });

  test("of a moment of the past are those of then, and cannot be written", async () => {
    await openPage();
    station.openFlight("current", 100);
    const then = {
      at_s: 100,
      identity: {
        station: null,
        board: null,
        firmware: null,
        aircraft: null,
        operator: null,
        emulated: false,
      },
      parameters: null,
      own: described({ line_k_bank: held(2.5) }),
      missions: { flight: null, hil: null },
    };
    for (const about of station.replay.questions) {
      await station.answered(`${about}`, then);
    }
    expect(field("line_k_bank").value).toBe("2.5");
    expect(field("line_k_bank").readOnly).toBe(true);
    const data = { table: null, values: { line_k_bank: held(3.5) } };
    station.replayed(({ wire }) => wire.deliver({ type: "event", event: "own_gains", t_s: 101, data }));
    expect(field("line_k_bank").value).toBe("3.5");
  });

  test("are found by the search, by the board's words too", async () => {
    await open();
    await user.type(screen.getByRole("textbox", { name: "Buscar" }), "bank error");
    expect(
      [...document.querySelectorAll("[data-parameter]")].map((one) => one.getAttribute("data-parameter")),
    ).toEqual(["line_k_bank", "bias"]);
    await user.clear(screen.getByRole("textbox", { name: "Buscar" }));
    await user.type(screen.getByRole("textbox", { name: "Buscar" }), "k_roll");
    expect(document.querySelectorAll("[data-parameter]")).toHaveLength(1);
  });
});

describe("the board's table", () => {
  test("says how far it is read", async () => {
    await open(described({}, { state: "reading", blocks_read: 8, block_count: 19, gains: [] }));
    expect(
      screen.getByText("Se está leyendo la tabla de ganancias propias de la placa: 8 de 19 bloques."),
    ).toBeDefined();
  });

  test("says which rows cannot be used and why, and the rest works", async () => {
    await open(described({}, { left_out: [{ row: 3, name: "Bad Name", reason: "name" }] }));
    expect(screen.getByText(/Fila 3 Bad Name:.*snake_case/)).toBeDefined();
    expect(field("line_k_bank").value).toBe("3");
  });
});

describe("a choice", () => {
  test("on the ground goes out at once", async () => {
    await open();
    await choose("line");
    expect(writes()).toEqual([{ guidance_law: 1 }]);
  });

  test("while the autopilot flies asks first, and goes out when it is confirmed", async () => {
    await open();
    station.send({ heartbeat: { autopilot_hil: true } });
    await choose("line");
    expect(writes()).toEqual([]);
    const question = screen.getByRole("alertdialog", { name: "¿Cambiar guidance_law en vuelo?" });
    await user.click(within(question).getByRole("button", { name: "Cambiar a line" }));
    expect(writes()).toEqual([{ guidance_law: 1 }]);
  });

  test("that is not confirmed changes nothing", async () => {
    await open();
    station.send({ heartbeat: { autopilot: true } });
    await choose("line");
    await user.click(screen.getByRole("button", { name: "Cancelar" }));
    expect(writes()).toEqual([]);
    expect(choice().value).toBe("deployed");
  });

  test("cannot be made while the board is lost", async () => {
    openUnanswered(aStatus({ board: { ...aStatus().board, state: "lost" } }));
    await answer({}, described());
    expect(choice().getAttribute("aria-disabled")).toBe("true");
  });
});
