import {
  Cartesian3,
  Math as CesiumMath,
  HeadingPitchRange,
  Matrix3,
  Matrix4,
  PerspectiveFrustum,
  Transforms,
} from "@cesium/engine";
import type { Aircraft } from "../../lib/aircraft";
import type { CameraMode } from "../../lib/mapCamera";
import { wrap180 } from "../../lib/units";
import type { Globe } from "../globe/Globe";
import type { AircraftLayer, AircraftPose } from "./AircraftLayer";
import { poseOf } from "./pose";

/** Distance and slope of the view from behind and above, until the user turns it. */
const BEHIND_M = 45;
const ABOVE_DEG = -14;
/** Time constant with which the camera follows the aircraft's turns, so that a gust does not shake the view. */
const TURN_S = 0.8;
const FOLLOW_FOV_DEG = 60;
const COCKPIT_FOV_DEG = 70;
/** Turn per key press. */
const KEY_TURN_DEG = 5;
const KEY_ZOOM = 1.2;

/** Moves the globe's camera with an aircraft, or leaves it to the user. */
export class CameraRig {
  readonly #globe: Globe;
  readonly #aircraft: AircraftLayer;
  readonly #endPictures: () => void;
  #mode: CameraMode = "free";
  #followed: Aircraft = "flight";
  #heading_deg: number | null = null;
  #moved_ms = 0;
  /** The camera's place relative to the aircraft when following ended. */
  #kept: Cartesian3 | null = null;
  #isHeld = false;

  constructor(globe: Globe, aircraft: AircraftLayer) {
    this.#globe = globe;
    this.#aircraft = aircraft;
    this.#endPictures = globe.onBeforePicture((now_ms) => this.#beforePicture(now_ms));
  }

  set(mode: CameraMode, aircraft: Aircraft): void {
    if (this.#isHeld && (mode !== "follow" || aircraft !== this.#followed)) {
      this.#release();
    }
    if (aircraft !== this.#followed) {
      this.#heading_deg = null;
    }
    this.#mode = mode;
    this.#followed = aircraft;
    const { camera, screenSpaceCameraController } = this.#globe.scene;
    screenSpaceCameraController.enableInputs = mode !== "cockpit";
    if (camera.frustum instanceof PerspectiveFrustum) {
      camera.frustum.fov = CesiumMath.toRadians(mode === "cockpit" ? COCKPIT_FOV_DEG : FOLLOW_FOV_DEG);
    }
    if (mode === "free") {
      this.#level();
    }
    this.#globe.requestRender();
  }

  /** A key of the map: arrows turn, plus and minus zoom. Returns false for other keys. */
  key(key: string): boolean {
    const { camera } = this.#globe.scene;
    const turn = CesiumMath.toRadians(KEY_TURN_DEG);
    const turns: Readonly<Record<string, () => void>> = {
      ArrowLeft: () => camera.rotateRight(turn),
      ArrowRight: () => camera.rotateLeft(turn),
      ArrowUp: () => camera.rotateUp(turn),
      ArrowDown: () => camera.rotateDown(turn),
    };
    const far_m = this.#isHeld ? Cartesian3.magnitude(camera.position) : camera.positionCartographic.height;
    const zooms: Readonly<Record<string, () => void>> = {
      "+": () => camera.zoomIn(far_m * (1 - 1 / KEY_ZOOM)),
      "-": () => camera.zoomOut(far_m * (KEY_ZOOM - 1)),
    };
    const act = this.#mode === "cockpit" ? undefined : (this.#freeTurns()[key] ?? turns[key] ?? zooms[key]);
    act?.();
    this.#globe.requestRender();
    return act !== undefined;
  }

  /** Heading, pitch and roll of the camera, degrees. */
  get attitude_deg(): readonly [number, number, number] {
    const { heading, pitch, roll } = this.#globe.scene.camera;
    return [CesiumMath.toDegrees(heading), CesiumMath.toDegrees(pitch), CesiumMath.toDegrees(roll)];
  }

  dispose(): void {
    this.#endPictures();
    this.#release();
  }

  /** Free, the arrows look around; following, they move around the aircraft. */
  #freeTurns(): Readonly<Record<string, () => void>> {
    const { camera } = this.#globe.scene;
    const turn = CesiumMath.toRadians(KEY_TURN_DEG);
    return this.#isHeld
      ? {}
      : {
          ArrowLeft: () => camera.lookLeft(turn),
          ArrowRight: () => camera.lookRight(turn),
          ArrowUp: () => camera.lookUp(turn),
          ArrowDown: () => camera.lookDown(turn),
        };
  }

  #beforePicture(now_ms: number): void {
    const seen = this.#aircraft.seen(this.#followed);
    this.#aircraft.setWithin(this.#mode === "cockpit" && seen?.attitude != null ? this.#followed : null);
    if (seen === null || this.#mode === "free") {
      this.#release();
    } else if (this.#mode === "follow") {
      this.#follow(seen, now_ms);
    } else {
      this.#sitIn(seen);
    }
    this.#moved_ms = now_ms;
  }

  #follow(seen: AircraftPose, now_ms: number): void {
    const { camera } = this.#globe.scene;
    this.#turnAfter(seen, (now_ms - this.#moved_ms) / 1000);
    const { latitude_deg, longitude_deg, altitude_m } = seen.place;
    const axes = Transforms.eastNorthUpToFixedFrame(
      Cartesian3.fromDegrees(longitude_deg, latitude_deg, altitude_m),
    );
    const turned = Matrix4.multiplyByMatrix3(
      axes,
      Matrix3.fromRotationZ(-CesiumMath.toRadians(this.#heading_deg ?? 0)),
      axes,
    );
    if (this.#isHeld) {
      // Keeps what the user has turned since the last picture.
      camera.lookAtTransform(turned, Cartesian3.clone(camera.position));
    } else {
      camera.lookAtTransform(
        turned,
        this.#kept ?? new HeadingPitchRange(0, CesiumMath.toRadians(ABOVE_DEG), BEHIND_M),
      );
      this.#isHeld = true;
    }
  }

  #turnAfter({ attitude }: AircraftPose, passed_s: number): void {
    if (attitude === null) {
      return;
    }
    const behind_deg = this.#heading_deg === null ? 0 : wrap180(attitude.yaw_deg - this.#heading_deg);
    const share = 1 - Math.exp(-Math.max(0, passed_s) / TURN_S);
    this.#heading_deg =
      this.#heading_deg === null ? attitude.yaw_deg : this.#heading_deg + share * behind_deg;
  }

  #sitIn({ place, attitude }: AircraftPose): void {
    if (attitude === null) {
      return;
    }
    this.#release();
    const { position, ahead, up } = poseOf(place, attitude);
    this.#globe.scene.camera.setView({
      destination: new Cartesian3(...position),
      orientation: { direction: new Cartesian3(...ahead), up: new Cartesian3(...up) },
    });
  }

  #release(): void {
    if (this.#isHeld) {
      const { camera } = this.#globe.scene;
      this.#kept = Cartesian3.clone(camera.position);
      camera.lookAtTransform(Matrix4.IDENTITY);
      this.#isHeld = false;
    }
  }

  /** Makes the horizon level again after a banked cockpit. */
  #level(): void {
    const { camera } = this.#globe.scene;
    camera.setView({ orientation: { heading: camera.heading, pitch: camera.pitch, roll: 0 } });
  }
}
