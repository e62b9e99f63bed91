import {
  BufferGeometry,
  CylinderGeometry,
  Float32BufferAttribute,
  LatheGeometry,
  SphereGeometry,
  Vector2,
} from "three";
import { mergeGeometries } from "three/examples/jsm/utils/BufferGeometryUtils.js";

/**
 * A small high-wing aircraft in the picture's axes: nose to -z, right wing to +x, up +y; 2.4 long, 3.2 wide. Made for
 * this project: a turned fuselage, and plates between two profiles.
 */
export interface AircraftShape {
  readonly body: BufferGeometry;
  readonly belly: BufferGeometry;
  readonly glass: BufferGeometry;
  readonly leftTip: BufferGeometry;
  readonly rightTip: BufferGeometry;
  readonly propeller: BufferGeometry;
}

/** Radius of the fuselage along it, from the nose (z = -1.15) to the tail (1.2). */
const FUSELAGE: readonly (readonly [radius: number, z: number])[] = [
  [0.02, -1.15],
  [0.1, -1.1],
  [0.16, -0.95],
  [0.2, -0.7],
  [0.22, -0.3],
  [0.2, 0.1],
  [0.13, 0.6],
  [0.07, 1.05],
  [0.02, 1.2],
];
const SIDES = 20;

type Point = readonly [x: number, y: number, z: number];

/** A tapered plate between two profiles, each: leading edge, trailing edge, half thickness across `thick`. */
function plate(inner: readonly [Point, Point], outer: readonly [Point, Point], thick: Point): BufferGeometry {
  const along = (point: Point, sign: number): Point => [
    point[0] + sign * thick[0],
    point[1] + sign * thick[1],
    point[2] + sign * thick[2],
  ];
  const middle = ([lead, trail]: readonly [Point, Point]): Point => [
    lead[0] + 0.35 * (trail[0] - lead[0]),
    lead[1] + 0.35 * (trail[1] - lead[1]),
    lead[2] + 0.35 * (trail[2] - lead[2]),
  ];
  // Each profile: leading edge, thickest place above, trailing edge, thickest place below.
  const ring = (profile: readonly [Point, Point]): Point[] => [
    profile[0],
    along(middle(profile), 1),
    profile[1],
    along(middle(profile), -1),
  ];
  const corners = [...ring(inner), ...ring(outer)];
  const faces: number[][] = [
    [0, 1, 2, 3],
    [7, 6, 5, 4],
  ];
  for (let side = 0; side < 4; side += 1) {
    const next = (side + 1) % 4;
    faces.push([side, side + 4, next + 4, next]);
  }
  const positions = faces.flatMap(([a = 0, b = 0, c = 0, d = 0]) =>
    [a, b, c, a, c, d].flatMap((corner) => [...(corners[corner] ?? [0, 0, 0])]),
  );
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new Float32BufferAttribute(positions, 3));
  geometry.computeVertexNormals();
  return geometry;
}

/** Mirrored to the other side, with its faces still outwards. */
function mirrored(geometry: BufferGeometry): BufferGeometry {
  const other = geometry.clone().scale(-1, 1, 1);
  const positions = other.getAttribute("position");
  for (let face = 0; face < positions.count; face += 3) {
    const [x, y, z] = [positions.getX(face), positions.getY(face), positions.getZ(face)];
    positions.setXYZ(face, positions.getX(face + 2), positions.getY(face + 2), positions.getZ(face + 2));
    positions.setXYZ(face + 2, x, y, z);
  }
  other.computeVertexNormals();
  return other;
}

function merged(parts: BufferGeometry[]): BufferGeometry {
  const plain = parts.map((part) => {
    const flat = part.index === null ? part : part.toNonIndexed();
    flat.deleteAttribute("uv");
    return flat;
  });
  const whole = mergeGeometries(plain);
  for (const part of new Set([...parts, ...plain])) {
    part.dispose();
  }
  return whole;
}

export function aircraftShape(): AircraftShape {
  const fuselage = new LatheGeometry(
    FUSELAGE.map(([radius, z]) => new Vector2(radius, z)),
    SIDES,
  ).rotateX(Math.PI / 2);
  const wing = plate(
    [
      [0, 0.21, -0.42],
      [0, 0.21, 0.14],
    ],
    [
      [1.3, 0.27, -0.34],
      [1.3, 0.27, 0.08],
    ],
    [0, 0.035, 0],
  );
  const tip = plate(
    [
      [1.3, 0.27, -0.34],
      [1.3, 0.27, 0.08],
    ],
    [
      [1.6, 0.285, -0.26],
      [1.6, 0.285, 0.06],
    ],
    [0, 0.034, 0],
  );
  const stabiliser = plate(
    [
      [0, 0.06, 0.86],
      [0, 0.06, 1.2],
    ],
    [
      [0.55, 0.06, 0.95],
      [0.55, 0.06, 1.2],
    ],
    [0, 0.02, 0],
  );
  const fin = plate(
    [
      [0, 0.03, 0.8],
      [0, 0.03, 1.2],
    ],
    [
      [0, 0.58, 1.05],
      [0, 0.58, 1.28],
    ],
    [0.02, 0, 0],
  );
  return {
    body: merged([fuselage, wing, mirrored(wing), stabiliser, mirrored(stabiliser), fin]),
    // A different colour below: which way is up matters most here.
    belly: new SphereGeometry(1, 16, 8, 0, 2 * Math.PI, Math.PI / 2, Math.PI / 2)
      .scale(0.17, 0.15, 0.62)
      .translate(0, -0.11, -0.3),
    glass: new SphereGeometry(1, 16, 8, 0, 2 * Math.PI, 0, Math.PI / 2)
      .scale(0.15, 0.14, 0.3)
      .translate(0, 0.12, -0.58),
    leftTip: mirrored(tip),
    rightTip: tip,
    propeller: new CylinderGeometry(0.34, 0.34, 0.015, 24).rotateX(Math.PI / 2).translate(0, 0, -1.14),
  };
}
