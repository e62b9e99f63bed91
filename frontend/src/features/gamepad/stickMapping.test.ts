import { describe, expect, test } from "vitest";
import {
  assigned,
  atRest,
  axisPosition,
  defaultMapping,
  movedInput,
  type Pad,
  type StickMapping,
  stickPosition,
} from "./stickMapping";

function pad(axes: readonly number[], others: Partial<Pad> = {}): Pad {
  return { id: "Pad", index: 0, isStandard: true, axes, buttons: [0, 0, 0, 0, 0, 0, 0, 0], ...others };
}

const released = pad([0, 0, 0, 0]);
const joystick = pad([0, 0, 0, 1], { isStandard: false });

function change(
  mapping: StickMapping,
  axis: keyof StickMapping,
  what: Partial<StickMapping["elevator"]>,
): StickMapping {
  return { ...mapping, [axis]: { ...mapping[axis], ...what } };
}

describe("a standard gamepad", () => {
  const mapping = defaultMapping(released);

  test("that is let go moves nothing and has its throttle closed", () => {
    expect(stickPosition(released, mapping)).toEqual({ elevator: 0, aileron: 0, rudder: 0, throttle: 0 });
  });

  test("pulled back is nose up, to the right is right wing down and nose right, pushed out is full throttle", () => {
    expect(stickPosition(pad([1, -1, 1, 1]), mapping)).toEqual({
      elevator: 1,
      aileron: 1,
      rudder: 1,
      throttle: 1,
    });
    expect(stickPosition(pad([-1, 1, -1, -1]), mapping)).toEqual({
      elevator: -1,
      aileron: -1,
      rudder: -1,
      throttle: 0,
    });
  });
});

describe("a joystick with a lever", () => {
  const mapping = defaultMapping(joystick);

  test("has its throttle over the lever's whole way", () => {
    expect(stickPosition(joystick, mapping)?.throttle).toBe(0);
    expect(stickPosition(pad([0, 0, 0, -1], { isStandard: false }), mapping)?.throttle).toBe(1);
  });

  test("without a twist keeps the rudder still", () => {
    const plain = pad([0, 0, 1], { isStandard: false });
    expect(stickPosition(plain, defaultMapping(plain))).toEqual({
      elevator: 0,
      aileron: 0,
      rudder: 0,
      throttle: 0,
    });
  });

  test("whose axis is not there, or says no number, has no position at all", () => {
    expect(stickPosition(pad([0, 0], { isStandard: false }), mapping)).toBeNull();
    expect(stickPosition(pad([0, Number.NaN, 0, 1], { isStandard: false }), mapping)).toBeNull();
    expect(stickPosition(joystick, change(mapping, "throttle", { input: null }))).toBeNull();
  });
});

describe("the dead zone", () => {
  const { elevator } = change(defaultMapping(released), "elevator", { deadZone: 0.2 });

  test("moves nothing inside, begins at zero at its edge and ends at the end", () => {
    const at = (value: number) => axisPosition(pad([0, 0, 0, value]), "elevator", elevator);
    expect([at(0.2), at(-0.19)]).toEqual([0, 0]);
    expect(at(0.21)).toBeCloseTo(0.0125, 4);
    expect(at(-0.6)).toBeCloseTo(-0.5, 9);
    expect([at(1), at(-1)]).toEqual([1, -1]);
  });
});

describe("the rest", () => {
  test("of a stick that is a little off the middle is the middle, with both ends where they were", () => {
    const worn = pad([0, 0, 0.1, -0.2]);
    const mapping = change(defaultMapping(worn), "elevator", { deadZone: 0 });
    expect(stickPosition(worn, mapping)).toEqual({ elevator: 0, aileron: 0, rudder: 0, throttle: 0 });
    expect(axisPosition(pad([0, 0, 0, 1]), "elevator", mapping.elevator)).toBe(1);
    expect(axisPosition(pad([0, 0, 0, -1]), "elevator", mapping.elevator)).toBe(-1);
  });

  test("is not taken of a stick that somebody holds, nor of a lever", () => {
    expect(atRest(defaultMapping(released), pad([0, 0, 0, 0.9])).elevator.rest).toBe(0);
    expect(atRest(defaultMapping(joystick), pad([0, 0, 0, 0.2], { isStandard: false })).throttle.rest).toBe(
      0,
    );
  });
});

describe("an axis that is assigned", () => {
  const mapping = defaultMapping(released);

  test("is the one that was moved farthest, and only if it was meant", () => {
    expect(movedInput(released, pad([0.2, 0, -0.8, 0.6]), "elevator")).toBe("a2");
    expect(movedInput(released, pad([0.2, 0, -0.4, 0.4]), "elevator")).toBeNull();
  });

  test("can be a trigger for the throttle and for nothing else", () => {
    const pressed = pad([0, 0, 0, 0], { buttons: [0, 0, 0, 0, 0, 0, 0, 0.9] });
    expect(movedInput(released, pressed, "aileron")).toBeNull();
    expect(movedInput(released, pressed, "throttle")).toBe("b7");
    const after = assigned(mapping, "throttle", "b7", released, pressed);
    expect(stickPosition(released, after)?.throttle).toBe(0);
    expect(stickPosition(pressed, change(after, "throttle", { deadZone: 0 }))?.throttle).toBeCloseTo(0.9, 9);
  });

  test("has the sign of the way in which it was moved", () => {
    const pushed = pad([0, -0.9, 0, 0]);
    const after = assigned(mapping, "elevator", "a1", released, pushed);
    expect(axisPosition(pad([0, -1, 0, 0]), "elevator", after.elevator)).toBe(1);
  });

  test("takes its input from what had it before", () => {
    expect(assigned(mapping, "elevator", "a1", released, pad([0, 0.9, 0, 0])).throttle.input).toBeNull();
  });

  test("springs back where it rested in the middle, and is a lever where it stood at an end", () => {
    const from = pad([0, 0, 0, 1]);
    expect(assigned(mapping, "throttle", "a3", from, pad([0, 0, 0, -1])).throttle).toMatchObject({
      isInverted: true,
      springs: false,
    });
    expect(assigned(mapping, "throttle", "a3", released, pad([0, 0, 0, -1])).throttle.springs).toBe(true);
  });
});
