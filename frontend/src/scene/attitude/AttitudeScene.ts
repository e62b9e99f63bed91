import { Color, DirectionalLight, Group, HemisphereLight, Quaternion as PictureTurn, Scene } from "three";
import {
  attitudeOf,
  type FullAttitude,
  type Quaternion,
  quaternionOf,
  turnFromPicture,
  turnInPicture,
  type Vector,
} from "../../lib/attitude";
import { AttitudeMotion } from "../../lib/attitudeMotion";
import { Aircraft } from "./Aircraft";
import { Arrow } from "./arrow";
import { Compass, type CompassWords } from "./Compass";
import { Label } from "./label";
import { type CameraView, OrbitRig } from "./OrbitRig";
import type { Palette } from "./palette";
import type { Act } from "./Stage";

export interface SceneWords extends CompassWords {
  readonly down: string;
  readonly axisX: string;
  readonly axisY: string;
  readonly axisZ: string;
  readonly acceleration: string;
  readonly field: string;
  /** Label of the aligned zero heading. */
  readonly zero: string;
}

/** The visible parts. */
export interface VisibleParts {
  readonly ghost: boolean;
  readonly bodyAxes: boolean;
  readonly worldAxes: boolean;
  readonly vectors: boolean;
}

/** Acceleration of gravity: an accelerometer at rest draws an arrow of `UNIT`. */
const GRAVITY_M_S2 = 9.80665;
/** Length in the scene of 1 g and of a field of one. */
const UNIT = 1.3;
const BODY_AXES: readonly Vector[] = [
  [1.75, 0, 0],
  [0, 2, 0],
  [0, 0, 1],
];
/** So short that their labels do not cover those of the rose or the airframe. */
const WORLD_AXES: readonly Vector[] = [
  [1.35, 0, 0],
  [0, 1.35, 0],
  [0, 0, 1.2],
];
const ZERO_PLACE = 2.75;

/**
 * The aircraft over a compass rose. Rotations are north-east-down; with an alignment the whole world is turned so
 * that the aligned heading is straight ahead.
 */
export class AttitudeScene implements Act {
  readonly scene = new Scene();
  readonly rig = new OrbitRig();
  readonly #motion = new AttitudeMotion();
  readonly #world = new Group();
  readonly #aircraft = new Aircraft();
  readonly #compass = new Compass();
  readonly #bodyAxes = BODY_AXES.map(() => new Arrow({ width: 0.014, labelHeight: 0.22 }));
  readonly #worldAxes = WORLD_AXES.map(() => new Arrow({ width: 0.009, labelHeight: 0.22 }));
  readonly #acceleration = new Arrow({ width: 0.026, labelHeight: 0.24 });
  readonly #field = new Arrow({ width: 0.026, labelHeight: 0.24 });
  readonly #zero = new Label(0.26);
  #shown: VisibleParts = { ghost: true, bodyAxes: true, worldAxes: true, vectors: true };
  #vectors: { acceleration_m_s2: Vector | null; field: Vector | null } = {
    acceleration_m_s2: null,
    field: null,
  };
  #follows = false;
  #zero_deg: number | null = null;
  #isLive = false;
  #palette: Palette | null = null;
  #turn: Quaternion | null = null;

  constructor() {
    const sun = new DirectionalLight(0xffffff, 1.9);
    sun.position.set(2.5, 5, 3.5);
    this.scene.add(new HemisphereLight(0xffffff, 0x707880, 1.7), sun, this.#world, this.#zero.sprite);
    this.#world.add(this.#compass.group, this.#aircraft.model, this.#aircraft.ghost);
    for (const [index, axis] of this.#worldAxes.entries()) {
      axis.point(WORLD_AXES[index] ?? null);
      this.#world.add(axis.group);
    }
    for (const [index, axis] of this.#bodyAxes.entries()) {
      axis.point(BODY_AXES[index] ?? null);
      this.#aircraft.model.add(axis.group);
    }
    this.#aircraft.model.add(this.#acceleration.group, this.#field.group);
    this.#zero.sprite.position.set(0, -1.2, -ZERO_PLACE);
  }

  get camera() {
    return this.rig.camera;
  }

  get isDressed(): boolean {
    return this.#palette !== null;
  }

  /** A sample of the attitude. */
  sample(attitude: FullAttitude, now_ms: number): void {
    const turn = quaternionOf(attitude);
    this.#motion.push(turn, now_ms);
    this.#turn ??= turn;
  }

  /** The source has changed or is gone. */
  clear(): void {
    this.#motion.clear();
    this.#turn = null;
  }

  setLive(isLive: boolean): void {
    this.#isLive = isLive;
    if (this.#palette !== null) {
      this.#aircraft.dress(this.#palette, isLive);
    }
  }

  /** The heading shown straight ahead, degrees; null: north. */
  setZero(zero_deg: number | null): void {
    this.#zero_deg = zero_deg;
    this.#world.rotation.y = ((zero_deg ?? 0) * Math.PI) / 180;
  }

  setShown(shown: VisibleParts): void {
    this.#shown = shown;
  }

  /** In the airframe's axes; null if not live. */
  setVectors(acceleration_m_s2: Vector | null, field: Vector | null): void {
    this.#vectors = { acceleration_m_s2, field };
  }

  /** Put the camera relative to the aircraft's present heading. */
  look(view: CameraView): void {
    this.rig.place(view, this.#shownYaw_deg());
  }

  setFollow(follows: boolean): void {
    this.#follows = follows;
  }

  dress(palette: Palette, words: SceneWords): void {
    this.#palette = palette;
    this.scene.background = new Color(palette.background);
    this.#aircraft.dress(palette, this.#isLive);
    this.#compass.dress(palette, words);
    const body = [
      [palette.axisX, words.axisX],
      [palette.axisY, words.axisY],
      [palette.axisZ, words.axisZ],
    ] as const;
    for (const [index, [colour, word]] of body.entries()) {
      this.#bodyAxes[index]?.dress(colour, word, palette.background);
    }
    for (const [index, word] of [words.north, words.east, words.down].entries()) {
      this.#worldAxes[index]?.dress(palette.muted, word, palette.background);
    }
    this.#acceleration.dress(palette.acceleration, words.acceleration, palette.background);
    this.#field.dress(palette.field, words.field, palette.background);
    this.#zero.write(words.zero, palette.axisX, palette.background);
  }

  advance(now_ms: number): boolean {
    const turn = this.#motion.shown(now_ms);
    const ghost = this.#shown.ghost && this.#isLive ? this.#motion.ghost(now_ms) : null;
    this.#turn = turn;
    this.#aircraft.model.visible = turn !== null;
    this.#aircraft.ghost.visible = ghost !== null;
    pose(this.#aircraft.model.quaternion, turn);
    pose(this.#aircraft.ghost.quaternion, ghost);
    this.#compass.pointNose(turn === null ? null : attitudeOf(turn).yaw_deg);
    for (const axis of this.#bodyAxes) {
      axis.group.visible = this.#shown.bodyAxes;
    }
    for (const axis of this.#worldAxes) {
      axis.group.visible = this.#shown.worldAxes;
    }
    const { acceleration_m_s2, field } = this.#shown.vectors
      ? this.#vectors
      : { acceleration_m_s2: null, field: null };
    this.#acceleration.point(scaled(acceleration_m_s2, UNIT / GRAVITY_M_S2));
    this.#field.point(scaled(field, UNIT));
    this.#zero.sprite.visible = this.#zero_deg !== null;
    if (this.#follows) {
      this.rig.follow(this.#shownYaw_deg());
    }
    this.rig.settle();
    this.scene.updateMatrixWorld();
    return this.#isLive && this.#motion.isMoving(now_ms, this.#shown.ghost);
  }

  /** The attitude that is drawn, read from the model itself; yaw is relative to straight ahead. */
  get shownAttitude(): FullAttitude | null {
    if (this.#turn === null) {
      return null;
    }
    const { x, y, z, w } = this.#aircraft.model.getWorldQuaternion(new PictureTurn());
    return attitudeOf(turnFromPicture([x, y, z, w]));
  }

  dispose(): void {
    this.#aircraft.dispose();
    this.#compass.dispose();
    this.#zero.dispose();
    for (const arrow of [...this.#bodyAxes, ...this.#worldAxes, this.#acceleration, this.#field]) {
      arrow.dispose();
    }
  }

  #shownYaw_deg(): number {
    return this.#turn === null ? 0 : attitudeOf(this.#turn).yaw_deg - (this.#zero_deg ?? 0);
  }
}

function pose(quaternion: PictureTurn, turn: Quaternion | null): void {
  if (turn !== null) {
    quaternion.set(...turnInPicture(turn));
  }
}

function scaled(vector: Vector | null, factor: number): Vector | null {
  return vector === null ? null : [vector[0] * factor, vector[1] * factor, vector[2] * factor];
}
