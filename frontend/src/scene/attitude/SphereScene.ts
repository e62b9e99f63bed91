import {
  BufferAttribute,
  BufferGeometry,
  Color,
  Group,
  LineBasicMaterial,
  LineSegments,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  Points,
  PointsMaterial,
  Scene,
  SphereGeometry,
  WireframeGeometry,
} from "three";
import { inPicture, type Vector } from "../../lib/attitude";
import type { FieldFit } from "../../lib/ellipsoid";
import { MOST_SAMPLES } from "../../lib/fieldSamples";
import { type Matrix3, spectral3 } from "../../lib/linear";
import { DIRECTIONS } from "../../lib/sphereCover";
import { Arrow } from "./arrow";
import { OrbitRig } from "./OrbitRig";
import type { Palette } from "./palette";
import type { Act } from "./Stage";

export interface SphereWords {
  readonly axisX: string;
  readonly axisY: string;
  readonly axisZ: string;
}

/** Radius of the field in the scene. */
const RADIUS = 1.7;
/** A little outside the readings. */
const MARKS_RADIUS = 1.12;
const NO_CHANGE: Matrix3 = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
];

/** The magnetometer's readings around their centre, the fitted surface, and the directions still missing. */
export class SphereScene implements Act {
  readonly scene = new Scene();
  readonly rig = new OrbitRig([0, 0, 0]);
  readonly #readings = new Group();
  readonly #positions = new BufferAttribute(new Float32Array(3 * MOST_SAMPLES), 3);
  readonly #points: Points<BufferGeometry, PointsMaterial>;
  readonly #now: Mesh<SphereGeometry, MeshBasicMaterial>;
  readonly #surface: LineSegments<WireframeGeometry, LineBasicMaterial>;
  readonly #seen: Points<BufferGeometry, PointsMaterial>;
  readonly #unseen: Points<BufferGeometry, PointsMaterial>;
  readonly #axes = [0, 1, 2].map(() => new Arrow({ width: 0.014, labelHeight: 0.2 }));
  readonly #sphere = new SphereGeometry(1, 24, 14);

  constructor() {
    this.#points = new Points(
      new BufferGeometry().setAttribute("position", this.#positions),
      new PointsMaterial({ size: 0.075 }),
    );
    this.#points.frustumCulled = false;
    this.#now = new Mesh(new SphereGeometry(0.06, 12, 8), new MeshBasicMaterial());
    this.#surface = new LineSegments(
      new WireframeGeometry(this.#sphere),
      new LineBasicMaterial({ transparent: true, opacity: 0.35 }),
    );
    this.#surface.matrixAutoUpdate = false;
    this.#seen = marks(0.09);
    this.#unseen = marks(0.12);
    // The readings are put into this group in their own unit and axes.
    this.#readings.matrixAutoUpdate = false;
    this.#readings.add(this.#points, this.#now, this.#surface);
    this.scene.add(this.#readings, this.#seen, this.#unseen);
    for (const [index, axis] of this.#axes.entries()) {
      axis.point([0, 1, 2].map((each) => (each === index ? 2.05 : 0)) as unknown as Vector);
      this.scene.add(axis.group);
    }
    this.rig.place("behind", 35);
    this.show([], null, 1, [0, 0, 0], []);
  }

  get camera() {
    return this.rig.camera;
  }

  get isDressed(): boolean {
    return this.scene.background !== null;
  }

  /** All readings, their fit, the radius and centre to draw them with, and the number of readings per direction. */
  show(
    points: readonly Vector[],
    fit: FieldFit | null,
    radius: number,
    centre: Vector,
    seen: readonly number[],
  ): void {
    for (const [index, point] of points.entries()) {
      this.#positions.setXYZ(index, ...inPicture(point));
    }
    this.#positions.needsUpdate = true;
    this.#points.geometry.setDrawRange(0, points.length);
    const scale = RADIUS / radius;
    const [x, y, z] = inPicture(centre);
    this.#readings.matrix.makeScale(scale, scale, scale).setPosition(-scale * x, -scale * y, -scale * z);
    this.#readings.matrixWorldNeedsUpdate = true;
    this.#now.scale.setScalar(1 / scale);
    this.#surface.visible = fit !== null;
    const matrix = fit === null ? NO_CHANGE : spectral3(fit.matrix, (value) => fit.radius / value);
    this.#surface.matrix.copy(matrixInPicture(matrix, fit?.offset ?? centre));
    place(this.#seen, (index) => (seen[index] ?? 0) > 0);
    place(this.#unseen, (index) => (seen[index] ?? 0) === 0);
  }

  /** The present reading; null if there is none. */
  point(reading: Vector | null): void {
    this.#now.visible = reading !== null;
    if (reading !== null) {
      this.#now.position.set(...inPicture(reading));
    }
  }

  dress(palette: Palette, words: SphereWords): void {
    this.scene.background = new Color(palette.background);
    this.#points.material.color.set(palette.text);
    this.#now.material.color.set(palette.field);
    this.#surface.material.color.set(palette.axisX);
    this.#seen.material.color.set(palette.good);
    this.#unseen.material.color.set(palette.acceleration);
    const axes = [
      [palette.axisX, words.axisX],
      [palette.axisY, words.axisY],
      [palette.axisZ, words.axisZ],
    ] as const;
    for (const [index, [colour, word]] of axes.entries()) {
      this.#axes[index]?.dress(colour, word, palette.background);
    }
  }

  advance(): boolean {
    this.rig.settle();
    this.scene.updateMatrixWorld();
    return false;
  }

  dispose(): void {
    for (const drawn of [this.#points, this.#now, this.#surface, this.#seen, this.#unseen]) {
      drawn.geometry.dispose();
      drawn.material.dispose();
    }
    this.#sphere.dispose();
    for (const axis of this.#axes) {
      axis.dispose();
    }
  }
}

function marks(size: number): Points<BufferGeometry, PointsMaterial> {
  const geometry = new BufferGeometry().setAttribute(
    "position",
    new BufferAttribute(new Float32Array(3 * DIRECTIONS.length), 3),
  );
  const made = new Points(geometry, new PointsMaterial({ size }));
  made.frustumCulled = false;
  return made;
}

/** Show only the directions for which this holds. */
function place(points: Points, holds: (index: number) => boolean): void {
  const positions = points.geometry.getAttribute("position") as BufferAttribute;
  let count = 0;
  for (const [index, direction] of DIRECTIONS.entries()) {
    if (holds(index)) {
      const [x, y, z] = inPicture(direction);
      const distance = RADIUS * MARKS_RADIUS;
      positions.setXYZ(count, distance * x, distance * y, distance * z);
      count += 1;
    }
  }
  positions.needsUpdate = true;
  points.geometry.setDrawRange(0, count);
}

/** A matrix in the airframe's axes, with a shift, converted to the picture's axes. */
function matrixInPicture(matrix: Matrix3, shift: Vector): Matrix4 {
  // Columns: the images of the picture's axes (right, up, aft), each an axis of the airframe.
  const column = (airframe: Vector): Vector =>
    inPicture(
      matrix.map((row) =>
        row.reduce((sum, value, axis) => sum + value * (airframe[axis] ?? 0), 0),
      ) as unknown as Vector,
    );
  const [x, y, z] = [column([0, 1, 0]), column([0, 0, -1]), column([-1, 0, 0])];
  const [dx, dy, dz] = inPicture(shift);
  return new Matrix4().set(x[0], y[0], z[0], dx, x[1], y[1], z[1], dy, x[2], y[2], z[2], dz, 0, 0, 0, 1);
}
