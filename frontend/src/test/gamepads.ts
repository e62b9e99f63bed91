import type { GamepadReader } from "../features/gamepad/gamepadInput";
import type { Pad } from "../features/gamepad/stickMapping";

/** The gamepads of a browser at the test's command. */
export class ManualGamepads implements GamepadReader {
  pads: readonly Pad[] = [];
  visible = true;
  #changed: () => void = () => undefined;

  readonly read = (): readonly Pad[] => this.pads;

  readonly isInSight = (): boolean => this.visible;

  readonly onChange = (run: () => void): (() => void) => {
    this.#changed = run;
    return () => {
      this.#changed = () => undefined;
    };
  };

  /** Plug in what a person has, and pull out what is not in the list. */
  plug(...pads: readonly Pad[]): void {
    this.pads = pads;
    this.#changed();
  }
}

/** A standard gamepad that is let go, but for what is said. */
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
