import { act, fireEvent, render, screen, within } from "@testing-library/react";
import { beforeEach, describe, expect, test } from "vitest";
import type { Status } from "../../protocol/contract";
import { aStatus, heldBy } from "../../test/aStatus";
import { Station } from "../../test/station";
import { Dialog } from "../../ui/Dialog";
import { WORDS } from "../../ui/test/testWords";
import { WordsProvider } from "../../ui/words";
import { TouchDock } from "./TouchDock";
import { TOUCH_PAD, TOUCH_STICK } from "./touchStick";

const HEARTBEAT = { source_joystick: true };
const MINE = {
  source: "gamepad",
  state: "live",
  client: "c1",
  name: "Ana",
  gamepad: TOUCH_PAD.id,
  samples: {},
} as const;
const SIMULATED = { ...aStatus().simulator, state: "open" } as const;

let station: Station;

function withStick(stick: Partial<Status["hil"]["stick"]>, others: Partial<Status> = {}): Status {
  const { hil } = aStatus();
  return aStatus({
    simulator: SIMULATED,
    hil: { ...hil, stick: { ...hil.stick, ...stick } as never },
    ...others,
  });
}

function pad(kind: "stick" | "lever"): HTMLElement {
  const found = document.querySelector<HTMLElement>(`[data-pad="${kind}"]`);
  if (found === null) throw new Error("the stick is not on the screen");
  return found;
}

/** jsdom has no pointer events: a mouse event of the same name replaces them. */
function finger(type: string, on: HTMLElement, x: number, y: number, pointerId = 1): void {
  const event = new MouseEvent(type, { bubbles: true, clientX: x, clientY: y, button: 0 });
  fireEvent(on, Object.assign(event, { pointerId }));
}

/** The samples sent since the last call. */
function samples(): Array<Record<string, unknown>> {
  const sent = station.wires.at(-1)?.sent.splice(0) ?? [];
  return sent.map((text) => JSON.parse(text)).filter(({ type }) => type === "stick");
}

/** Time passes; the board and the gateway go on as they are. */
function pass(ms: number): Array<Record<string, unknown>> {
  samples();
  station.pass(ms);
  return samples();
}

beforeEach(() => {
  Element.prototype.setPointerCapture ??= () => undefined;
  station = new Station(
    <WordsProvider words={WORDS}>
      <TouchDock />
    </WordsProvider>,
  );
  station.greet(withStick({}));
  station.send({ heartbeat: HEARTBEAT, xplane_info: { throttle: 0.6 } });
  act(() => station.page.parts.get(TOUCH_STICK).store.setState({ isOpen: true }));
  station.show();
});

test("a finger on the stick asks for it, with samples that begin in the middle and with the power that is", () => {
  finger("pointerdown", pad("stick"), 300, 300);
  expect(station.asked.at(-1)).toMatchObject({
    method: "PUT",
    path: "/api/v1/hil",
    body: { stick: "gamepad", gamepad: TOUCH_PAD.id },
  });
  expect(samples().at(-1)).toMatchObject({ elevator: 0, aileron: 0, rudder: 0, throttle: 0.6 });
});

describe.each([
  ["a viewer", withStick({}, { control: heldBy("c2", "Luis") }), HEARTBEAT],
  ["without a simulator", aStatus({ simulator: { ...SIMULATED, state: "closed" } }), HEARTBEAT],
  ["with RC as source", withStick({}), { source_joystick: false }],
  ["while a gamepad flies", withStick({ ...MINE, gamepad: "Pad" }), HEARTBEAT],
])("%s", (_, status, heartbeat) => {
  test("the finger does nothing, and it is said why", () => {
    station.status(status);
    station.send({ heartbeat });
    finger("pointerdown", pad("stick"), 300, 300);
    expect(station.asked.filter(({ method }) => method === "PUT")).toEqual([]);
    expect(pass(100)).toEqual([]);
    const said = within(screen.getByRole("region", { name: "Palanca en la pantalla" })).getAllByRole(
      "status",
    );
    expect(said.map(({ textContent }) => textContent).join()).not.toContain("Pon un dedo");
  });
});

describe("while it flies", () => {
  beforeEach(() => {
    station.status(withStick(MINE));
    finger("pointerdown", pad("stick"), 300, 300);
    finger("pointermove", pad("stick"), 332, 300);
  });

  test("its position leaves fifty times a second", () => {
    const sent = pass(200);
    expect(sent.length).toBeGreaterThanOrEqual(9);
    expect(Number(sent[0]?.["aileron"])).toBeGreaterThan(0.4);
  });

  test("a finger that is lifted sends nothing more, above all no middle", () => {
    samples();
    finger("pointerup", pad("stick"), 332, 300);
    expect(samples()).toEqual([]);
    expect(pass(400)).toEqual([]);
  });

  test.each([
    ["the system takes the finger", () => finger("pointercancel", pad("stick"), 332, 300)],
    [
      "the system takes the second finger",
      () => {
        finger("pointerdown", pad("lever"), 50, 300, 2);
        samples();
        finger("pointercancel", pad("lever"), 50, 300, 2);
      },
    ],
    ["another window comes to the front", () => fireEvent.blur(window)],
    [
      "a dialog opens",
      () => {
        render(
          <WordsProvider words={WORDS}>
            <Dialog title="Aviso" onClose={() => undefined} />
          </WordsProvider>,
        ).unmount();
      },
    ],
    ["the page is hidden", () => fireEvent(document, new Event("visibilitychange"))],
    [
      "the control goes to somebody else",
      () => station.status(withStick(MINE, { control: heldBy("c2", "Luis") })),
    ],
  ])("%s: nothing leaves, until the finger comes again", (_, happens) => {
    samples();
    happens();
    samples();
    finger("pointermove", pad("stick"), 360, 300);
    expect(pass(200)).toEqual([]);
    station.status(withStick(MINE));
    station.send({ heartbeat: HEARTBEAT });
    expect(pass(200)).toEqual([]);
    finger("pointerup", pad("stick"), 360, 300);
    finger("pointerdown", pad("stick"), 300, 300);
    expect(pass(100).length).toBeGreaterThan(0);
  });

  test("another finger beside the first on the same pad is not heard, and its leaving neither", () => {
    finger("pointerdown", pad("stick"), 200, 200, 7);
    finger("pointermove", pad("stick"), 100, 100, 7);
    finger("pointerup", pad("stick"), 100, 100, 7);
    expect(Number(pass(100).at(-1)?.["aileron"])).toBeGreaterThan(0.4);
  });

  test("put away, it gives the stick back to the simulator", () => {
    fireEvent.click(screen.getByRole("button", { name: "Guardar la palanca" }));
    expect(station.asked.at(-1)).toMatchObject({ method: "PUT", body: { stick: "simulator" } });
    expect(pass(200)).toEqual([]);
  });
});
