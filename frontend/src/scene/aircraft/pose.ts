import { type FullAttitude, quaternionOf, rotated, type Vector } from "../../lib/attitude";
import { writeEcef } from "../../lib/ecef";

/** A position: degrees, and metres above the sea, which the globe takes as above the ellipsoid. */
export interface Place {
  readonly latitude_deg: number;
  readonly longitude_deg: number;
  readonly altitude_m: number;
}

/**
 * An airframe's position and attitude in earth-centred axes: x through the Gulf of Guinea, z through the north pole.
 */
export interface Pose {
  /** Metres from the Earth's centre. */
  readonly position: Vector;
  /** Of length one. */
  readonly ahead: Vector;
  readonly right: Vector;
  readonly up: Vector;
}

export function poseOf(place: Place, attitude: FullAttitude): Pose {
  const position = new Float64Array(3);
  writeEcef(position, 0, place.latitude_deg, place.longitude_deg, place.altitude_m);
  const turn = quaternionOf(attitude);
  const inEarth = (body: Vector): Vector => fromLocal(rotated(turn, body), place);
  return {
    position: [position[0] ?? 0, position[1] ?? 0, position[2] ?? 0],
    ahead: inEarth([1, 0, 0]),
    right: inEarth([0, 1, 0]),
    up: inEarth([0, 0, -1]),
  };
}

/**
 * The matrix, by columns, of a model with its nose to +x, left wing to +y and up +z: so the engine turns a glTF with
 * nose +z and up +y.
 */
export function modelMatrix({ position, ahead, right, up }: Pose): number[] {
  const [rightX, rightY, rightZ] = right;
  return [...ahead, 0, -rightX, -rightY, -rightZ, 0, ...up, 0, ...position, 1];
}

/** North, east, down at a place, in the Earth's axes. */
function fromLocal([north, east, down]: Vector, { latitude_deg, longitude_deg }: Place): Vector {
  const latitude = (latitude_deg * Math.PI) / 180;
  const longitude = (longitude_deg * Math.PI) / 180;
  const [sinLatitude, cosLatitude] = [Math.sin(latitude), Math.cos(latitude)];
  const [sinLongitude, cosLongitude] = [Math.sin(longitude), Math.cos(longitude)];
  // Away from the Earth's axis, within the meridian.
  const outwards = -north * sinLatitude - down * cosLatitude;
  return [
    outwards * cosLongitude - east * sinLongitude,
    outwards * sinLongitude + east * cosLongitude,
    north * cosLatitude - down * sinLatitude,
  ];
}
