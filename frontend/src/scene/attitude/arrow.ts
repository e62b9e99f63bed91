import { ConeGeometry, CylinderGeometry, Group, Mesh, MeshBasicMaterial, Quaternion, Vector3 } from "three";
import { inPicture, type Vector } from "../../lib/attitude";
import { Label } from "./label";

const HEAD = 0.16;
const ALONG = new Vector3(0, 1, 0);
/** A vector shorter than this is not drawn: its direction could not be seen. */
const SHORTEST = 0.02;
const DOWNWARD = -0.3;

interface Look {
  readonly width: number;
  readonly labelHeight: number;
}

/** An arrow from its parent's origin with a label at its tip, along a vector ahead-right-down or north-east-down. */
export class Arrow {
  readonly group = new Group();
  readonly #shaft: Mesh;
  readonly #head: Mesh;
  readonly #material = new MeshBasicMaterial();
  readonly #label: Label;
  readonly #turn = new Quaternion();
  readonly #direction = new Vector3();

  constructor({ width, labelHeight }: Look) {
    this.#shaft = new Mesh(new CylinderGeometry(width, width, 1, 8).translate(0, 0.5, 0), this.#material);
    this.#head = new Mesh(new ConeGeometry(3 * width, HEAD, 12).translate(0, HEAD / 2, 0), this.#material);
    this.#label = new Label(labelHeight);
    this.group.add(this.#shaft, this.#head, this.#label.sprite);
  }

  /** In the scene's units; null hides it. */
  point(vector: Vector | null): void {
    const length = vector === null ? 0 : Math.hypot(...vector);
    this.group.visible = length > SHORTEST;
    if (vector === null || !this.group.visible) {
      return;
    }
    this.#direction.set(...inPicture(vector)).divideScalar(length);
    this.#turn.setFromUnitVectors(ALONG, this.#direction);
    const shaft = Math.max(0.001, length - HEAD);
    this.#shaft.quaternion.copy(this.#turn);
    this.#shaft.scale.set(1, shaft, 1);
    this.#head.quaternion.copy(this.#turn);
    this.#head.position.copy(this.#direction).multiplyScalar(shaft);
    this.#label.sprite.position.copy(this.#direction).multiplyScalar(length);
    // Above the tip, or below the tip of one that points down: beside it, a long label would cover a level arrow.
    this.#label.sprite.center.set(0.5, this.#direction.y < DOWNWARD ? 1.1 : -0.1);
  }

  dress(colour: string, word: string, plate: string): void {
    this.#material.color.set(colour);
    this.#label.write(word, colour, plate);
  }

  dispose(): void {
    this.#shaft.geometry.dispose();
    this.#head.geometry.dispose();
    this.#material.dispose();
    this.#label.dispose();
  }
}
