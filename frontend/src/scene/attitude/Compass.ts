import {
  BufferGeometry,
  CircleGeometry,
  DoubleSide,
  Float32BufferAttribute,
  Group,
  LineBasicMaterial,
  LineLoop,
  LineSegments,
  Mesh,
  MeshBasicMaterial,
} from "three";
import { Label } from "./label";
import type { Palette } from "./palette";

const RADIUS = 2.1;
const FLOOR = -1.2;
const TICK = 0.12;
const LONG_TICK = 0.24;
const LETTER_PLACE = RADIUS + 0.24;

export interface CompassWords {
  readonly north: string;
  readonly east: string;
  readonly south: string;
  readonly west: string;
}

/** A compass rose on the floor, with a line under the nose. */
export class Compass {
  readonly group = new Group();
  readonly #line = new LineBasicMaterial();
  readonly #noseLine = new LineBasicMaterial();
  readonly #floor = new MeshBasicMaterial({
    transparent: true,
    opacity: 0.35,
    side: DoubleSide,
    depthWrite: false,
  });
  readonly #geometries: BufferGeometry[] = [];
  readonly #letters: Label[];
  readonly #nose: LineSegments;

  constructor() {
    const ring = points(
      Array.from({ length: 72 }, (_, index) => [index * 5, RADIUS] as const).flatMap((at) => spot(...at)),
    );
    const ticks = points(
      Array.from({ length: 36 }, (_, index) => index * 10).flatMap((course) => [
        ...spot(course, RADIUS),
        ...spot(course, RADIUS - (course % 30 === 0 ? LONG_TICK : TICK)),
      ]),
    );
    const nose = points([...spot(0, 0), ...spot(0, RADIUS)]);
    const floor = new CircleGeometry(RADIUS, 48).rotateX(-Math.PI / 2);
    this.#geometries.push(ring, ticks, nose, floor);
    this.#nose = new LineSegments(nose, this.#noseLine);
    this.group.position.y = FLOOR;
    this.group.add(
      new Mesh(floor, this.#floor),
      new LineLoop(ring, this.#line),
      new LineSegments(ticks, this.#line),
      this.#nose,
    );
    this.#letters = [0, 90, 180, 270].map((course) => {
      const letter = new Label(0.3);
      letter.sprite.position.set(...spot(course, LETTER_PLACE));
      this.group.add(letter.sprite);
      return letter;
    });
  }

  /** Heading of the nose, degrees; null if unknown. */
  pointNose(heading_deg: number | null): void {
    this.#nose.visible = heading_deg !== null;
    this.#nose.rotation.y = (-(heading_deg ?? 0) * Math.PI) / 180;
  }

  dress(palette: Palette, words: CompassWords): void {
    this.#line.color.set(palette.line);
    this.#noseLine.color.set(palette.text);
    this.#floor.color.set(palette.belly);
    const texts = [words.north, words.east, words.south, words.west];
    for (const [index, letter] of this.#letters.entries()) {
      letter.write(texts[index] ?? "", palette.text, palette.background);
    }
  }

  dispose(): void {
    for (const geometry of this.#geometries) {
      geometry.dispose();
    }
    for (const letter of this.#letters) {
      letter.dispose();
    }
    this.#line.dispose();
    this.#noseLine.dispose();
    this.#floor.dispose();
  }
}

/** A point of the floor by its course from the middle. */
function spot(course_deg: number, radius: number): [number, number, number] {
  const course = (course_deg * Math.PI) / 180;
  return [Math.sin(course) * radius, 0, -Math.cos(course) * radius];
}

function points(positions: readonly number[]): BufferGeometry {
  return new BufferGeometry().setAttribute("position", new Float32BufferAttribute(positions, 3));
}
