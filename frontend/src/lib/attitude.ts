import { DEGREES_PER_RADIAN, wrap360 } from "./units";

/**
 * Attitude of the airframe against local north-east-down, degrees: yaw clockwise from north seen from above, pitch nose
 * up, roll right wing down are positive. Turned in this order: yaw, then pitch, then roll, each about the turned axes.
 */
export interface FullAttitude {
  readonly yaw_deg: number;
  readonly pitch_deg: number;
  readonly roll_deg: number;
}

/** In the airframe's axes: ahead, right, down. In the ground's axes: north, east, down. Each function says which. */
export type Vector = readonly [number, number, number];

/** A unit quaternion x, y, z, w: rotates a vector from the airframe's axes to the ground's. */
export type Quaternion = readonly [number, number, number, number];

export function quaternionOf({ yaw_deg, pitch_deg, roll_deg }: FullAttitude): Quaternion {
  const [sinYaw, cosYaw] = half(yaw_deg);
  const [sinPitch, cosPitch] = half(pitch_deg);
  const [sinRoll, cosRoll] = half(roll_deg);
  return [
    cosYaw * cosPitch * sinRoll - sinYaw * sinPitch * cosRoll,
    cosYaw * sinPitch * cosRoll + sinYaw * cosPitch * sinRoll,
    sinYaw * cosPitch * cosRoll - cosYaw * sinPitch * sinRoll,
    cosYaw * cosPitch * cosRoll + sinYaw * sinPitch * sinRoll,
  ];
}

/**
 * The angles of a rotation: yaw 0..360, pitch -90..90, roll -180..180. Straight up or down, all rotation counts as
 * yaw.
 */
export function attitudeOf(turn: Quaternion): FullAttitude {
  const [northAhead, eastAhead, downAhead] = rotated(turn, [1, 0, 0]);
  const [northRight, eastRight, downRight] = rotated(turn, [0, 1, 0]);
  const downBelly = rotated(turn, [0, 0, 1])[2];
  const pitch_deg = Math.asin(Math.max(-1, Math.min(1, -downAhead))) * DEGREES_PER_RADIAN;
  // Within a hundredth of a degree of the vertical the nose has no heading; use the right wing's.
  if (Math.hypot(northAhead, eastAhead) < 1.7e-4) {
    return { yaw_deg: degrees360(Math.atan2(-northRight, eastRight)), pitch_deg, roll_deg: 0 };
  }
  return {
    yaw_deg: degrees360(Math.atan2(eastAhead, northAhead)),
    pitch_deg,
    roll_deg: Math.atan2(downRight, downBelly) * DEGREES_PER_RADIAN,
  };
}

/** A vector of the airframe in the ground's axes. */
export function rotated([x, y, z, w]: Quaternion, [a, b, c]: Vector): Vector {
  const tx = 2 * (y * c - z * b);
  const ty = 2 * (z * a - x * c);
  const tz = 2 * (x * b - y * a);
  return [a + w * tx + y * tz - z * ty, b + w * ty + z * tx - x * tz, c + w * tz + x * ty - y * tx];
}

/** The smaller angle between two rotations, degrees. */
export function angleBetween_deg(from: Quaternion, to: Quaternion): number {
  // From their difference, not from their product: exact for small angles.
  const sign = dot(from, to) < 0 ? -1 : 1;
  const difference = Math.hypot(...from.map((part, index) => part - sign * (to[index] ?? 0)));
  return 4 * Math.asin(Math.min(1, difference / 2)) * DEGREES_PER_RADIAN;
}

/** The rotation at `share` (0..1) of the way, at constant speed along the shorter path. */
export function between(from: Quaternion, to: Quaternion, share: number): Quaternion {
  const cosine = dot(from, to);
  const sign = cosine < 0 ? -1 : 1;
  const angle = Math.acos(Math.min(1, Math.abs(cosine)));
  const near = angle < 1e-4;
  const weightFrom = near ? 1 - share : Math.sin((1 - share) * angle) / Math.sin(angle);
  const weightTo = (sign * (near ? share : Math.sin(share * angle))) / (near ? 1 : Math.sin(angle));
  const mixed = from.map((part, index) => weightFrom * part + weightTo * (to[index] ?? 0));
  const length = Math.hypot(...mixed);
  const [x = 0, y = 0, z = 0, w = 1] = mixed.map((part) => part / length);
  return [x, y, z, w];
}

/**
 * From north-east-down, or ahead-right-down, to the picture's axes: x east (right), y up, z south (aft). Both are
 * right-handed, so rotations keep their sense.
 */
export function inPicture([north, east, down]: Vector): Vector {
  return [east, -down, -north];
}

export function turnInPicture([x, y, z, w]: Quaternion): Quaternion {
  return [...inPicture([x, y, z]), w];
}

/** The airframe's rotation from one in the picture's axes. */
export function turnFromPicture([x, y, z, w]: Quaternion): Quaternion {
  return [-z, x, -y, w];
}

function dot(one: Quaternion, other: Quaternion): number {
  return one[0] * other[0] + one[1] * other[1] + one[2] * other[2] + one[3] * other[3];
}

function half(angle_deg: number): readonly [number, number] {
  const half_rad = angle_deg / 2 / DEGREES_PER_RADIAN;
  return [Math.sin(half_rad), Math.cos(half_rad)];
}

function degrees360(angle_rad: number): number {
  return wrap360(angle_rad * DEGREES_PER_RADIAN);
}
