import type { GamepadReader } from "../features/gamepad/gamepadList";
import type { Pad } from "../features/gamepad/stickMapping";

/** A browser's gamepads under the test's control. */
export class ManualGamepads implements GamepadReader {
  pads: readonly Pad[] = [];
  visible = true;
  #changed: (connected?: number) => void = () => undefined;

  /** What reading them throws. */
  failure: Error | null = null;

  readonly read = (): readonly Pad[] => {
    if (this.failure !== null) {
      throw this.failure;
    }
    return this.pads;
  };

  readonly isInSight = (): boolean => this.visible;

  readonly onChange = (run: (connected?: number) => void): (() => void) => {
    this.#changed = run;
    return () => {
      this.#changed = () => undefined;
    };
  };

  /** Connect exactly these gamepads. */
  plug(...pads: readonly Pad[]): void {
    this.pads = pads;
    this.#changed();
  }

  /** Connect this gamepad again so fast that nobody has read the gamepads without it. */
  plugAgain(pad: Pad): void {
    this.pads = [pad];
    this.#changed(pad.index);
  }
}

/** A standard gamepad at rest, except for the given values. */
export function aPad(others: Partial<Pad> = {}): Pad {
  return {
    id: "Test Pad",
    index: 0,
    isStandard: true,
    axes: [0, 0, 0, 0],
    buttons: [0, 0, 0, 0, 0, 0, 0, 0],
    ...others,
  };
}
