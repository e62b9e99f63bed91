import type { PadName } from "./gamepadList";
import { type Pad, STICK_AXES, type StickAxis, type StickMapping } from "./stickMapping";

/** More than a worn stick trembles, less than anybody moves it on purpose. */
const MOVED = 0.05;

interface Reading {
  /** The axes as they were read when the gamepad was connected. */
  readonly first: readonly number[];
  readonly moved: Set<number>;
  isAgreed: boolean;
}

/**
 * Which axes of the connected gamepads have moved since they were connected. Until an axis moves, a browser reports 0 or
 * another value that its driver begins with: on a lever, half or full throttle that nobody has set.
 */
export class MovedAxes {
  readonly #readings = new Map<string, Reading>();

  /** Compare the gamepads' axes with those at their connection; forget the gamepads that are gone. */
  follow(pads: readonly Pad[]): void {
    const there = new Set(pads.map(keyOf));
    for (const key of this.#readings.keys()) {
      if (!there.has(key)) {
        this.#readings.delete(key);
      }
    }
    for (const pad of pads) {
      const { first, moved } = this.#of(pad);
      pad.axes.forEach((value, place) => {
        if (Math.abs(value - (first[place] ?? 0)) > MOVED) {
          moved.add(place);
        }
      });
    }
  }

  /** The gamepad with this index was connected: also where nobody has seen that it was gone. */
  connected(index: number): void {
    for (const key of this.#readings.keys()) {
      if (key.startsWith(`${index}:`)) {
        this.#readings.delete(key);
      }
    }
  }

  /** The pilot says that the gamepad's axes stand as they are read. */
  agree(pad: Pad): void {
    this.#of(pad).isAgreed = true;
  }

  /** The mapped axes whose position is not known yet. A device that needs no mapping knows its own position. */
  awaited(pad: Pad, mapping: StickMapping): readonly StickAxis[] {
    const { moved, isAgreed } = this.#of(pad);
    if (isAgreed || pad.mapping !== undefined) {
      return [];
    }
    return STICK_AXES.filter((axis) => {
      const { input } = mapping[axis];
      return input?.startsWith("a") === true && !moved.has(Number(input.slice(1)));
    });
  }

  #of(pad: Pad): Reading {
    const key = keyOf(pad);
    const reading = this.#readings.get(key) ?? { first: pad.axes, moved: new Set(), isAgreed: false };
    this.#readings.set(key, reading);
    return reading;
  }
}

function keyOf({ id, index }: PadName): string {
  return `${index}:${id}`;
}
