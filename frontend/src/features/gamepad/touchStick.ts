import { createStore, type StoreApi } from "zustand/vanilla";
import { partName } from "../../store/parts";
import type { GamepadReader, PadName } from "./gamepadList";
import type { AxisMapping, Pad, StickMapping, StickPosition } from "./stickMapping";

/** What the gateway and other pages call it; no gamepad has this index. */
export const TOUCH_PAD: PadName = { id: "Touch stick", index: 99 };

/** A point of the screen, in CSS pixels; y grows downwards. */
export interface Point {
  readonly x: number;
  readonly y: number;
}

export interface TouchStick {
  /** Whether it is on the screen, and whether a finger holds it. */
  readonly store: StoreApi<{ readonly isOpen: boolean; readonly isHeld: boolean }>;
  readonly position: () => StickPosition;
  /** A finger on the stick: here it stands in the middle. `throttle` 0..1: what flies now, so that power does not jump. */
  readonly hold: (at: Point, throttle: number) => void;
  readonly move: (to: Point) => void;
  /** A second finger, on the lever of throttle and rudder; counts only while the stick is held. */
  readonly holdLever: (at: Point) => void;
  readonly moveLever: (to: Point) => void;
  /** The second finger left: the rudder springs back, the throttle stays, as those of a transmitter do. */
  readonly leaveLever: () => void;
  /** No finger holds the stick: as a gamepad that is pulled out, nothing is sent and the gateway lets the stick go. */
  readonly letGo: () => void;
}

export const TOUCH_STICK = partName<TouchStick>("touchStick");

/** From the middle to the stop, and from closed to full throttle. */
export const TRAVEL_PX = 64;
const THROTTLE_PX = 110;

function axis(input: `a${number}`, deadZone: number): AxisMapping {
  return { input, isInverted: false, deadZone, rest: 0, springs: false };
}

const MAPPING: StickMapping = {
  elevator: axis("a0", 0.04),
  aileron: axis("a1", 0.04),
  rudder: axis("a2", 0.04),
  throttle: axis("a3", 0),
};

const NEUTRAL: StickPosition = { elevator: 0, aileron: 0, rudder: 0, throttle: 0 };

/** A stick on the screen. It is a gamepad that is there only while a finger holds it: that is its whole safety. */
export function createTouchStick(): { readonly stick: TouchStick; readonly reader: TouchReader } {
  const store = createStore(() => ({ isOpen: false, isHeld: false }));
  let position = NEUTRAL;
  let origin: Point = { x: 0, y: 0 };
  let lever: { readonly at: Point; readonly throttle: number } | null = null;
  let onChange: () => void = () => undefined;

  function become(isHeld: boolean): void {
    if (store.getState().isHeld !== isHeld) {
      store.setState({ isHeld });
      onChange();
    }
  }

  const stick: TouchStick = {
    store,
    position: () => position,
    hold: (at, throttle) => {
      origin = at;
      lever = null;
      position = { ...NEUTRAL, throttle: within(throttle, 0) };
      become(true);
    },
    move: (to) => {
      if (store.getState().isHeld) {
        // Pulled towards the pilot is nose up.
        position = { ...position, aileron: travel(to.x - origin.x), elevator: travel(to.y - origin.y) };
      }
    },
    holdLever: (at) => {
      if (store.getState().isHeld) {
        lever = { at, throttle: position.throttle };
      }
    },
    moveLever: (to) => {
      if (lever !== null) {
        const throttle = within(lever.throttle + (lever.at.y - to.y) / THROTTLE_PX, 0);
        position = { ...position, rudder: travel(to.x - lever.at.x), throttle };
      }
    },
    leaveLever: () => {
      lever = null;
      position = { ...position, rudder: 0 };
    },
    letGo: () => {
      lever = null;
      position = NEUTRAL;
      become(false);
    },
  };

  return {
    stick,
    reader: {
      read: () => (store.getState().isHeld ? [padAt(position)] : []),
      onChange: (run) => {
        onChange = run;
        return () => {
          onChange = () => undefined;
        };
      },
    },
  };
}

type TouchReader = Pick<GamepadReader, "read" | "onChange">;

/** The browser's gamepads, and the stick on the screen among them. */
export function withTouchStick(browser: GamepadReader, touch: TouchReader): GamepadReader {
  return {
    read: () => [...browser.read(), ...touch.read()],
    isInSight: browser.isInSight,
    onChange: (run) => {
      const cancels = [browser.onChange(run), touch.onChange(run)];
      return () => {
        for (const cancel of cancels) {
          cancel();
        }
      };
    },
  };
}

function padAt({ elevator, aileron, rudder, throttle }: StickPosition): Pad {
  return {
    ...TOUCH_PAD,
    isStandard: false,
    axes: [elevator, aileron, rudder, 2 * throttle - 1],
    buttons: [],
    mapping: MAPPING,
  };
}

function travel(distance_px: number): number {
  return within(distance_px / TRAVEL_PX, -1);
}

function within(value: number, least: number): number {
  return Math.min(1, Math.max(least, value));
}
