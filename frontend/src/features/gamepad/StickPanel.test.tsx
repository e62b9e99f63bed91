import { act, screen, within } from "@testing-library/react";
import userEvent from "@testing-library/user-event";
import { beforeEach, describe, expect, test } from "vitest";
import type { Status } from "../../protocol/contract";
import { aStatus, heldBy } from "../../test/aStatus";
import { aPad } from "../../test/gamepads";
import { Station } from "../../test/station";
import { WORDS } from "../../ui/test/testWords";
import { WordsProvider } from "../../ui/words";
import { GAMEPADS } from "./gamepadList";
import { StickPanel } from "./StickPanel";
import type { Pad } from "./stickMapping";

let station: Station;
const user = userEvent.setup();

type Stick = NonNullable<Status["hil"]["stick"]>;
const SIMULATOR: Stick = {
  source: "simulator",
  state: null,
  client: null,
  name: null,
  gamepad: null,
  samples: {},
};

/** A status with this stick. */
function withStick(stick: Partial<Stick>, others: Partial<Status> = {}): Status {
  return aStatus({ hil: { ...aStatus().hil, stick: { ...SIMULATOR, ...stick } }, ...others });
}

const MINE = { source: "gamepad", state: "live", client: "c1", name: "Torre", gamepad: "Test Pad" } as const;

function panel(): HTMLElement {
  return screen.getByRole("region", { name: "Palanca del piloto" });
}

function choice(name: string): HTMLElement {
  return within(panel()).getByRole("radio", { name });
}

function bar(axis: string): string | null {
  const [, inner] = within(panel()).getAllByRole("group", { name: axis });
  return inner?.getAttribute("data-value") ?? null;
}

/** The samples sent since the last call. */
function samples(): Array<Record<string, unknown>> {
  const sent = station.wires.at(-1)?.sent.splice(0) ?? [];
  return sent.map((text) => JSON.parse(text)).filter(({ type }) => type === "stick");
}

/** What the panel says of axes whose position is not known. */
function awaited(): string | undefined {
  return within(panel())
    .queryByText(/^Esperando ejes/, { selector: "p" })
    ?.textContent?.split(".")[0];
}

/** Every axis there and back, as a pilot checks them. */
function moveAll(others: Partial<Pad> = {}): void {
  act(() => station.gamepads.plug(aPad({ ...others, axes: [0.4, 0.4, 0.4, 0.4] })));
  act(() => station.gamepads.plug(aPad(others)));
}

/** Only the panel, without the window around it. */
beforeEach(() => {
  station = new Station(
    <WordsProvider words={WORDS}>
      <StickPanel />
    </WordsProvider>,
  );
  station.greet();
});

test("without a gamepad none can be chosen, and the panel says what to do", () => {
  expect(choice("Mando de este navegador").getAttribute("aria-disabled")).toBe("true");
  expect(within(panel()).getByText(/pulsa uno de sus botones/, { selector: ".ui-notice-text" })).toBeTruthy();
});

test("a viewer's gamepad cannot be chosen", () => {
  act(() => station.gamepads.plug(aPad()));
  station.status(aStatus({ control: heldBy("c2", "Otra") }));
  expect(choice("Mando de este navegador").getAttribute("aria-disabled")).toBe("true");
});

describe("a gamepad whose axes have not moved since it was connected", () => {
  /** A joystick: its lever reads 0, which is half throttle, until it moves. */
  const joystick = { id: "Lever", isStandard: false } as const;

  beforeEach(() => act(() => station.gamepads.plug(aPad(joystick))));

  test("cannot be chosen, and the panel says which axes it waits for until each was moved", () => {
    expect(awaited()).toBe("Esperando ejes: Elevator, Aileron, Rudder, Throttle");
    expect(choice("Mando de este navegador").getAttribute("aria-disabled")).toBe("true");
    act(() => station.gamepads.plug(aPad({ ...joystick, axes: [0.3, -0.3, 0, 0.02] })));
    expect(awaited()).toBe("Esperando ejes: Rudder, Throttle");
    act(() => station.gamepads.plug(aPad({ ...joystick, axes: [0, 0, 0.3, -1] })));
    expect(awaited()).toBeUndefined();
    expect(choice("Mando de este navegador").getAttribute("aria-disabled")).toBeNull();
  });

  test("can be chosen once the pilot confirms the positions, and not after it was connected again", async () => {
    await user.click(within(panel()).getByRole("button", { name: "Las barras son correctas" }));
    expect(awaited()).toBeUndefined();
    act(() => station.gamepads.plugAgain(aPad(joystick)));
    expect(awaited()).toBe("Esperando ejes: Elevator, Aileron, Rudder, Throttle");
  });

  test("does not fly on with half throttle when it is connected again in flight, and every tab is told", () => {
    moveAll(joystick);
    station.status(withStick({ ...MINE, gamepad: "Lever" }));
    station.pass(100);
    expect(samples().length).toBeGreaterThan(0);
    act(() => station.gamepads.plug());
    act(() => station.gamepads.plug(aPad(joystick)));
    station.pass(200);
    expect(samples()).toEqual([]);
    expect(told()).toMatchObject({ key: "gamepad.awaitedInFlight", params: { gamepad: "Lever" } });
    moveAll(joystick);
    station.pass(100);
    expect(samples().length).toBeGreaterThan(0);
  });
});

test("a bar that cannot be painted does not stop the stick, nor what else follows it", () => {
  moveAll();
  station.status(withStick(MINE));
  const painted: Array<number | null> = [];
  const { watch } = station.page.parts.get(GAMEPADS);
  let isFirst = true;
  act(() => {
    watch(() => {
      if (isFirst) {
        isFirst = false;
        throw new Error("no canvas");
      }
    });
    watch(({ aileron }) => painted.push(aileron));
  });
  samples();
  painted.length = 0;
  station.pass(200);
  expect(samples().length).toBeGreaterThan(5);
  expect(painted.length).toBeGreaterThan(5);
  expect(station.reported).toHaveLength(1);
});

test("a step that fails is reported, and the next one flies", () => {
  moveAll();
  station.status(withStick(MINE));
  station.gamepads.failure = new Error("driver");
  station.pass(100);
  station.gamepads.failure = null;
  samples();
  station.pass(200);
  expect(samples().length).toBeGreaterThan(5);
  expect(station.reported).toHaveLength(1);
});

describe("with a gamepad", () => {
  beforeEach(() => {
    act(() => station.gamepads.plug(aPad()));
    moveAll();
  });

  test("each axis has a bar that follows it, and nothing is sent", () => {
    act(() => station.gamepads.plug(aPad({ axes: [0, 0, 0.55, -1] })));
    station.pass(40);
    expect([bar("Elevator"), bar("Aileron"), bar("Throttle")]).toEqual(["-1.000", "0.500", "0.000"]);
    expect(samples()).toEqual([]);
  });

  test("it is chosen by its name, and its first samples leave with the question", async () => {
    await user.click(choice("Mando de este navegador"));
    expect(station.asked.at(-1)).toMatchObject({
      method: "PUT",
      path: "/api/v1/hil",
      body: { stick: "gamepad", gamepad: "Test Pad" },
    });
    expect(samples()).toMatchObject([{ elevator: 0, aileron: 0, rudder: 0, throttle: 0 }]);
  });

  test("a refusal stands beside the switch in the page's language", async () => {
    await user.click(choice("Mando de este navegador"));
    await station.asked.at(-1)?.answer({ code: "stick_silent", detail: "Silent.", params: {} }, 409);
    expect(within(panel()).getByRole("alert").textContent).toContain("no llega nada de él");
    station.pass(1500);
    samples();
    station.pass(500);
    expect(samples()).toEqual([]);
  });

  test("an axis is assigned by moving it, in its direction, and remembered for this gamepad", async () => {
    await user.click(within(panel()).getByRole("button", { name: "Asignar Aileron" }));
    expect(within(panel()).getByText("Mueve hacia la derecha…")).toBeTruthy();
    station.pass(40);
    act(() => station.gamepads.plug(aPad({ axes: [-0.9, 0, 0, 0] })));
    station.pass(40);
    act(() => station.gamepads.plug());
    station.pass(40);
    expect(within(panel()).queryByRole("button", { name: "Asignar Aileron" })).toBeNull();
    act(() => station.gamepads.plug(aPad({ axes: [-1, 0, 1, 0] })));
    station.pass(40);
    expect(bar("Aileron")).toBe("1.000");
    expect(within(panel()).getByRole("checkbox", { name: "Invertir Aileron" })).toHaveProperty(
      "checked",
      true,
    );
  });

  test("without an axis for the elevator it cannot be chosen", async () => {
    await user.click(within(panel()).getByRole("button", { name: "Asignar Rudder" }));
    station.pass(40);
    act(() => station.gamepads.plug(aPad({ axes: [0, 0, 0, 1] })));
    station.pass(40);
    expect(choice("Mando de este navegador").getAttribute("aria-disabled")).toBe("true");
    expect(
      within(panel()).getByText("Asigna antes Elevator, Aileron y Throttle.", {
        selector: ".ui-notice-text",
      }),
    ).toBeTruthy();
  });

  describe("that flies", () => {
    beforeEach(() => {
      station.status(withStick(MINE));
      station.pass(600);
      act(() => station.gamepads.plug(aPad({ axes: [1, -1, 0.55, 1] })));
      samples();
    });

    test("its position leaves fifty times a second with the page's clock", () => {
      station.send({});
      const from_ms = station.timers.now_ms();
      station.pass(200);
      const sent = samples().filter(({ t_ms }) => Number(t_ms) > from_ms && Number(t_ms) <= from_ms + 200);
      expect(sent).toHaveLength(10);
      expect(sent[0]).toMatchObject({ elevator: 1, aileron: 0.5, rudder: 1, throttle: 1 });
    });

    test("nothing leaves once it is pulled out, and another gamepad does not fly in its place", () => {
      act(() => station.gamepads.plug(aPad({ id: "Other Pad" })));
      samples();
      station.pass(200);
      expect(samples()).toEqual([]);
      expect(within(panel()).queryByRole("group", { name: "Elevator" })).toBeNull();
      act(() => station.gamepads.plug(aPad()));
      moveAll();
      station.pass(100);
      expect(samples().length).toBeGreaterThan(0);
    });

    test("nothing leaves while the page is hidden, for the browser does not read the gamepad then", () => {
      station.gamepads.visible = false;
      station.pass(200);
      expect(samples()).toEqual([]);
    });

    test("nothing leaves behind what still waits in the browser", () => {
      const wire = station.wires.at(-1);
      if (wire !== undefined) {
        wire.waiting_bytes = 100;
      }
      station.pass(200);
      expect(samples()).toEqual([]);
    });

    test("nothing leaves any more when the gateway takes the stick from it", () => {
      station.status(withStick({}));
      samples();
      station.pass(200);
      expect(samples()).toEqual([]);
    });

    test("that it is lost stands there as long as it is", () => {
      station.status(withStick({ ...MINE, state: "lost" }));
      expect(within(panel()).getByRole("alert").textContent).toContain("No llega nada del mando Test Pad");
    });
  });

  test("a gamepad at another page is named with that page, and this one's stays still", () => {
    station.status(withStick({ ...MINE, client: "c2" }, { control: heldBy("c2", "Torre") }));
    expect(within(panel()).getByText("La palanca es el mando Test Pad de la página Torre.")).toBeTruthy();
    station.pass(200);
    expect(samples()).toEqual([]);
  });
});

function told() {
  return station.page.messages.getState().last;
}

test("every page is told who flies with what, and why that ended", () => {
  const data = { source: "gamepad", state: "live", client: "c2", name: "Torre", gamepad: "Test Pad" };
  station.deliver({ type: "event", event: "stick", t_s: 0, data: { ...data, reason: "chosen" } });
  expect(told()).toMatchObject({
    key: "stickSaid.other",
    params: { gamepad: "Test Pad", name: "Torre" },
  });
  const gone = {
    ...data,
    source: "simulator",
    state: null,
    client: null,
    name: null,
    reason: "control_lost",
  };
  station.deliver({ type: "event", event: "stick", t_s: 0, data: gone });
  expect(told()).toMatchObject({ level: "warning", key: "stickSaid.control_lost" });
});
