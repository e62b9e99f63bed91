import { type BufferGeometry, DoubleSide, Group, Mesh, MeshLambertMaterial } from "three";
import { aircraftShape } from "./aircraftShape";
import type { Palette } from "./palette";

const PARTS = ["body", "belly", "glass", "leftTip", "rightTip", "propeller"] as const;
type Part = (typeof PARTS)[number];

const COLOURS: Readonly<Record<Part, keyof Palette>> = {
  body: "body",
  belly: "belly",
  glass: "glass",
  leftTip: "left",
  rightTip: "right",
  propeller: "muted",
};
const GHOST_OPACITY = 0.22;

/** The aircraft and its ghost, which has the same shape. */
export class Aircraft {
  readonly model = new Group();
  readonly ghost: Group;
  readonly #materials = new Map<Part, MeshLambertMaterial>();
  readonly #ghostMaterial = new MeshLambertMaterial({
    transparent: true,
    opacity: GHOST_OPACITY,
    depthWrite: false,
    side: DoubleSide,
  });
  readonly #geometries: BufferGeometry[] = [];

  constructor() {
    const shape = aircraftShape();
    this.ghost = new Group();
    for (const part of PARTS) {
      const material = new MeshLambertMaterial({ side: DoubleSide });
      if (part === "propeller") {
        material.transparent = true;
        material.opacity = 0.35;
        material.depthWrite = false;
      }
      this.#materials.set(part, material);
      this.#geometries.push(shape[part]);
      this.model.add(new Mesh(shape[part], material));
      if (part !== "propeller") {
        this.ghost.add(new Mesh(shape[part], this.#ghostMaterial));
      }
    }
  }

  /** All grey while the data is not live. */
  dress(palette: Palette, isLive: boolean): void {
    for (const [part, material] of this.#materials) {
      material.color.set(isLive ? palette[COLOURS[part]] : palette.grey);
    }
    this.#ghostMaterial.color.set(palette.muted);
  }

  dispose(): void {
    for (const geometry of this.#geometries) {
      geometry.dispose();
    }
    for (const material of this.#materials.values()) {
      material.dispose();
    }
    this.#ghostMaterial.dispose();
  }
}
