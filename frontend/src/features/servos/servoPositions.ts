import { createStore, type StoreApi } from "zustand/vanilla";
import type { CommandState } from "../../store/commands";
import type { Message } from "../../store/messages";
import { partName } from "../../store/parts";

/** Servo outputs of the board. */
export const SERVO_COUNT = 20;
/** The first four follow the autopilot until they are moved, and again when the control mode is chosen. */
export const DRIVEN_SERVOS = 4;

export interface Servo {
  /** The last requested position, -1..+1; null if there is none: the board does not report its servos. */
  readonly position: number | null;
  /** The outcome of the newest move. */
  readonly state: CommandState;
  readonly message: Message | null;
}

export const UNMOVED: Servo = { position: null, state: "idle", message: null };

export interface Servos {
  readonly servos: readonly Servo[];
}

export type ServoStore = StoreApi<Servos>;

/** The sliders of the servo outputs. */
export interface ServoSliders {
  readonly store: ServoStore;
  /** Request this position. Of moves that come faster than they can be sent, each servo's newest wins. */
  readonly move: (servo: number, position: number) => void;
}

export const SERVO_SLIDERS = partName<ServoSliders>("servos");

export function createServos(): ServoStore {
  return createStore<Servos>(() => ({ servos: Array.from({ length: SERVO_COUNT }, () => UNMOVED) }));
}

export function setServo(store: ServoStore, index: number, change: Partial<Servo>): void {
  store.setState(({ servos }) => ({
    servos: servos.map((servo, at) => (at === index ? { ...servo, ...change } : servo)),
  }));
}

/** The positions of the first `count` servos are unknown from now on. */
export function forgetServos(store: ServoStore, count: number = SERVO_COUNT): void {
  store.setState(({ servos }) => ({
    servos: servos.map((servo, index) => (index < count ? UNMOVED : servo)),
  }));
}
