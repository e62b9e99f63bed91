/** What a stick moves, in display order. */
export const STICK_AXES = ["elevator", "aileron", "rudder", "throttle"] as const;
export type StickAxis = (typeof STICK_AXES)[number];

/** Elevator + nose up, aileron + right wing down, rudder + nose right, each -1..+1; throttle 0..1. */
export type StickPosition = Readonly<Record<StickAxis, number>>;

/** A gamepad or joystick as the browser read it: axes -1..+1, buttons 0..1. */
export interface Pad {
  readonly id: string;
  readonly index: number;
  /** The browser knows the model and uses the standard layout: axes 0 and 1 the left stick, 2 and 3 the right one. */
  readonly isStandard: boolean;
  readonly axes: readonly number[];
  readonly buttons: readonly number[];
  /** Of a device that needs no choice: which of its axes moves what. */
  readonly mapping?: StickMapping;
}

/** An axis or a button of a gamepad, such as `a0` or `b7`. */
export type PadInput = `a${number}` | `b${number}`;

export interface AxisMapping {
  readonly input: PadInput | null;
  readonly isInverted: boolean;
  /** Share of the travel around the rest position that counts as zero; for a throttle, at its closed end. */
  readonly deadZone: number;
  /** The axis's value when it is released. */
  readonly rest: number;
  /** A throttle on a self-centring stick: released is closed, and only travel beyond the middle counts. */
  readonly springs: boolean;
}

export type StickMapping = Readonly<Record<StickAxis, AxisMapping>>;

export const MAX_DEAD_ZONE = 0.5;
/** No axis rests further out than this: it is being held. */
const FARTHEST_REST = 0.2;
/** An axis moved this far is meant: more than a trembling hand, less than the travel of a worn stick. */
const MEANT = 0.5;

function raw(pad: Pad, input: PadInput): number | null {
  const place = Number(input.slice(1));
  const value = input.startsWith("a") ? pad.axes[place] : pad.buttons[place];
  return value === undefined || !Number.isFinite(value) ? null : value;
}

/** Travel from the rest, -1..+1: zero inside the dead zone, without a jump at its edge. */
function fromRest(value: number, rest: number, deadZone: number): number {
  const way = value >= rest ? (value - rest) / (1 - rest) : (value - rest) / (1 + rest);
  const size = (Math.abs(way) - deadZone) / (1 - deadZone);
  return size <= 0 ? 0 : Math.sign(way) * Math.min(1, size);
}

/** Position of one axis; null if the gamepad does not have it. */
export function axisPosition(pad: Pad, axis: StickAxis, mapping: AxisMapping): number | null {
  const { input, isInverted, deadZone, rest, springs } = mapping;
  const value = input === null ? null : raw(pad, input);
  if (input === null || value === null) {
    return null;
  }
  if (axis !== "throttle" || (springs && input.startsWith("a"))) {
    const way = fromRest(value, rest, deadZone) * (isInverted ? -1 : 1);
    return axis === "throttle" ? Math.max(0, way) : way + 0;
  }
  const share = input.startsWith("a") ? (value + 1) / 2 : value;
  const open = isInverted ? 1 - share : share;
  return Math.min(1, Math.max(0, (open - deadZone) / (1 - deadZone)));
}

/** The stick's position; null if an axis that flies is missing. Without pedals the rudder stays at zero. */
export function stickPosition(pad: Pad, mapping: StickMapping): StickPosition | null {
  const elevator = axisPosition(pad, "elevator", mapping.elevator);
  const aileron = axisPosition(pad, "aileron", mapping.aileron);
  const throttle = axisPosition(pad, "throttle", mapping.throttle);
  const rudder = mapping.rudder.input === null ? 0 : axisPosition(pad, "rudder", mapping.rudder);
  return elevator === null || aileron === null || rudder === null || throttle === null
    ? null
    : { elevator, aileron, rudder, throttle };
}

function mapped(input: PadInput | null, deadZone: number, others: Partial<AxisMapping> = {}): AxisMapping {
  return { input, isInverted: false, deadZone, rest: 0, springs: false, ...others };
}

/**
 * The usual mapping. A gamepad as a transmitter of mode 2: right stick elevator and aileron, left stick rudder and,
 * beyond the middle, throttle. A joystick: stick, twist, lever.
 */
export function defaultMapping(pad: Pad): StickMapping {
  if (pad.isStandard) {
    return atRest(
      {
        elevator: mapped("a3", 0.1),
        aileron: mapped("a2", 0.1),
        rudder: mapped("a0", 0.1),
        throttle: mapped("a1", 0.1, { isInverted: true, springs: true }),
      },
      pad,
    );
  }
  const hasTwist = pad.axes.length > 3;
  return atRest(
    {
      elevator: mapped("a1", 0.05),
      aileron: mapped("a0", 0.05),
      rudder: mapped(hasTwist ? "a2" : null, 0.05),
      throttle: mapped(hasTwist ? "a3" : "a2", 0.02, { isInverted: true }),
    },
    pad,
  );
}

/** Take the present positions as rest; an axis that is being held keeps its old rest. */
export function atRest(mapping: StickMapping, pad: Pad): StickMapping {
  const entries = STICK_AXES.map((axis) => {
    const one = mapping[axis];
    const value = one.input?.startsWith("a") ? raw(pad, one.input) : null;
    const rests = value !== null && Math.abs(value) <= FARTHEST_REST && (axis !== "throttle" || one.springs);
    return [axis, rests ? { ...one, rest: value } : one];
  });
  return Object.fromEntries(entries) as unknown as StickMapping;
}

/** The input that moved farthest between two readings; null if none moved far enough. */
export function movedInput(before: Pad, now: Pad, axis: StickAxis): PadInput | null {
  const ways: Array<readonly [PadInput, number]> = now.axes.map((value, place) => [
    `a${place}`,
    Math.abs(value - (before.axes[place] ?? value)),
  ]);
  // A button has no middle position: it can only be a throttle.
  if (axis === "throttle") {
    ways.push(
      ...now.buttons.map((value, place): readonly [PadInput, number] => [
        `b${place}`,
        Math.abs(value - (before.buttons[place] ?? value)),
      ]),
    );
  }
  const [farthest] = ways.sort(([, first], [, second]) => second - first);
  return farthest !== undefined && farthest[1] >= MEANT ? farthest[0] : null;
}

/**
 * The mapping with the moved input assigned to this axis. The user moved it nose up, right wing down, nose right or
 * to full throttle, so its direction gives the sign; its position before gives the rest, and whether a throttle is
 * self-centring.
 */
export function assigned(
  mapping: StickMapping,
  axis: StickAxis,
  input: PadInput,
  before: Pad,
  now: Pad,
): StickMapping {
  const from = raw(before, input) ?? 0;
  const rests = input.startsWith("a") && Math.abs(from) <= FARTHEST_REST;
  const one: AxisMapping = {
    input,
    isInverted: (raw(now, input) ?? 0) < from,
    deadZone: mapping[axis].deadZone,
    rest: rests ? from : 0,
    springs: axis === "throttle" && rests,
  };
  // One input moves one axis: take it away from the axis that had it.
  const freed = STICK_AXES.map((other) => [
    other,
    mapping[other].input === input ? { ...mapping[other], input: null } : mapping[other],
  ]);
  return { ...(Object.fromEntries(freed) as unknown as StickMapping), [axis]: one };
}
