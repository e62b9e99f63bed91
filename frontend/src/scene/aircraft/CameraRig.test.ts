import {
  Camera,
  Cartesian3,
  Math as CesiumMath,
  GeographicProjection,
  PerspectiveFrustum,
  type Scene,
  SceneMode,
} from "@cesium/engine";
import { beforeEach, describe, expect, test } from "vitest";
import type { Aircraft } from "../../lib/aircraft";
import type { FullAttitude } from "../../lib/attitude";
import type { Globe } from "../globe/Globe";
import type { AircraftLayer, AircraftPose } from "./AircraftLayer";
import { CameraRig } from "./CameraRig";

const GANDO = { latitude_deg: 27.93, longitude_deg: -15.387, altitude_m: 305 };
const PLACE = Cartesian3.fromDegrees(GANDO.longitude_deg, GANDO.latitude_deg, GANDO.altitude_m);

function level(yaw_deg: number): FullAttitude {
  return { yaw_deg, pitch_deg: 0, roll_deg: 0 };
}

function flying(attitude: FullAttitude | null, place = GANDO): AircraftPose {
  return { place, t_s: 0, attitude, isLive: true, label: "EPF" };
}

/** As much of a globe as a camera asks for, and two aircraft over it. */
class Sky {
  readonly scene: Scene;
  readonly camera: Camera;
  readonly controls = { enableInputs: true };
  readonly seen: Record<Aircraft, AircraftPose | null> = { flight: null, hil: null };
  within: Aircraft | null = null;
  asked = 0;
  #picture: ((now_ms: number) => void) | null = null;
  #now_ms = 0;
  readonly rig: CameraRig;

  constructor() {
    const projection = new GeographicProjection();
    this.scene = {
      mode: SceneMode.SCENE3D,
      mapProjection: projection,
      ellipsoid: projection.ellipsoid,
      drawingBufferWidth: 800,
      drawingBufferHeight: 600,
      canvas: { clientWidth: 800, clientHeight: 600 },
      tweens: undefined,
    } as unknown as Scene;
    this.camera = new Camera(this.scene);
    Object.assign(this.scene, { camera: this.camera, screenSpaceCameraController: this.controls });
    const globe = {
      scene: this.scene,
      onBeforePicture: (hear: (now_ms: number) => void) => {
        this.#picture = hear;
        return () => {
          this.#picture = null;
        };
      },
      requestRender: () => {
        this.asked += 1;
      },
    };
    const aircraft = {
      seen: (which: Aircraft) => this.seen[which],
      setWithin: (which: Aircraft | null) => {
        this.within = which;
      },
    };
    this.rig = new CameraRig(globe as unknown as Globe, aircraft as unknown as AircraftLayer);
    this.camera.setView({ destination: Cartesian3.fromDegrees(-15.3, 27.75, 25_000) });
  }

  /** One more picture, so many seconds after the last one. */
  picture(passed_s = 0.02): void {
    this.#now_ms += 1000 * passed_s;
    this.#picture?.(this.#now_ms);
  }

  get isHeard(): boolean {
    return this.#picture !== null;
  }

  get away_m(): number {
    return Cartesian3.distance(this.camera.positionWC, PLACE);
  }

  get heading_deg(): number {
    return this.rig.attitude_deg[0];
  }

  get fov_deg(): number {
    const { frustum } = this.camera;
    return frustum instanceof PerspectiveFrustum ? CesiumMath.toDegrees(frustum.fov ?? 0) : Number.NaN;
  }
}

let sky: Sky;
beforeEach(() => {
  sky = new Sky();
});

/** Degrees from one direction to another, -180..180. */
function turn(from_deg: number, to_deg: number): number {
  return ((((to_deg - from_deg + 180) % 360) + 360) % 360) - 180;
}

function follow(attitude: FullAttitude | null, which: Aircraft = "flight"): void {
  sky.seen[which] = flying(attitude);
  sky.rig.set("follow", which);
  sky.picture();
}

describe("a camera that follows", () => {
  test("flies behind and above the aircraft and looks where it flies", () => {
    follow(level(90));
    expect(sky.away_m).toBeCloseTo(45, 3);
    const [heading, pitch, roll] = sky.rig.attitude_deg;
    expect(heading).toBeCloseTo(90, 1);
    expect(pitch).toBeCloseTo(-14, 1);
    expect(turn(0, roll)).toBeCloseTo(0, 1);
    // Behind an aircraft on an easterly course is west of it.
    expect(CesiumMath.toDegrees(sky.camera.positionCartographic.longitude)).toBeLessThan(GANDO.longitude_deg);
  });

  test("keeps its distance while the aircraft flies on", () => {
    follow(level(0));
    const on = { ...GANDO, latitude_deg: GANDO.latitude_deg + 0.01 };
    sky.seen.flight = flying(level(0), on);
    sky.picture();
    const there = Cartesian3.fromDegrees(on.longitude_deg, on.latitude_deg, on.altitude_m);
    expect(Cartesian3.distance(sky.camera.positionWC, there)).toBeCloseTo(45, 3);
  });

  test("turns after the aircraft softly, the shorter way through north", () => {
    follow(level(350));
    sky.seen.flight = flying(level(10));
    sky.picture(0.8);
    // Two thirds of the way in the time constant.
    expect(turn(350, sky.heading_deg)).toBeCloseTo(20 * (1 - Math.exp(-1)), 1);
    sky.picture(10);
    expect(turn(10, sky.heading_deg)).toBeCloseTo(0, 1);
  });

  test("keeps its direction while the attitude is unknown, and when the clock is set back", () => {
    follow(level(120));
    sky.seen.flight = flying(null);
    sky.picture(5);
    expect(sky.heading_deg).toBeCloseTo(120, 1);
    sky.seen.flight = flying(level(200));
    sky.picture(-3);
    expect(sky.heading_deg).toBeCloseTo(120, 1);
  });

  test("looks north after an aircraft whose attitude was never known", () => {
    follow(null);
    expect(turn(0, sky.heading_deg)).toBeCloseTo(0, 1);
    expect(sky.away_m).toBeCloseTo(45, 3);
  });

  test("keeps what a person has turned, also after a while of flying freely", () => {
    follow(level(0));
    expect(sky.rig.key("ArrowRight")).toBe(true);
    sky.picture();
    const turned_deg = turn(0, sky.heading_deg);
    // About the camera's own upright, which leans a little.
    expect(Math.abs(turned_deg)).toBeCloseTo(5, 0);
    sky.rig.set("free", "flight");
    sky.picture();
    sky.camera.setView({ destination: Cartesian3.fromDegrees(0, 50, 9000) });
    sky.rig.set("follow", "flight");
    sky.picture();
    expect(sky.away_m).toBeCloseTo(45, 3);
    expect(turn(0, sky.heading_deg)).toBeCloseTo(turned_deg, 1);
  });

  test("looks where the other aircraft flies at once when that one is followed", () => {
    follow(level(0));
    follow(level(180), "hil");
    expect(turn(180, sky.heading_deg)).toBeCloseTo(0, 1);
  });

  test("stays where it is when its aircraft is no longer seen", () => {
    follow(level(45));
    const before = Cartesian3.clone(sky.camera.positionWC);
    sky.seen.flight = null;
    sky.picture();
    expect(Cartesian3.distance(sky.camera.positionWC, before)).toBeLessThan(1e-3);
    sky.picture();
    expect(Cartesian3.distance(sky.camera.positionWC, before)).toBeLessThan(1e-3);
  });
});

describe("a camera in the cockpit", () => {
  test("sits in the aircraft and banks with it, and no hand moves it", () => {
    sky.seen.flight = flying({ yaw_deg: 200, pitch_deg: 8, roll_deg: -30 });
    sky.rig.set("cockpit", "flight");
    sky.picture();
    expect(sky.away_m).toBeLessThan(1);
    const [heading, pitch, roll] = sky.rig.attitude_deg;
    expect(heading).toBeCloseTo(200, 2);
    expect(pitch).toBeCloseTo(8, 2);
    expect(turn(-30, roll)).toBeCloseTo(0, 2);
    expect(sky.controls.enableInputs).toBe(false);
    expect(sky.fov_deg).toBeCloseTo(70, 6);
    expect(sky.within).toBe("flight");
  });

  test("takes no key", () => {
    sky.rig.set("cockpit", "flight");
    const before = Cartesian3.clone(sky.camera.direction);
    expect(["ArrowLeft", "ArrowUp", "+", "-"].map((key) => sky.rig.key(key))).toEqual(Array(4).fill(false));
    expect(sky.camera.direction).toEqual(before);
  });

  test("of an aircraft whose attitude is unknown stays outside, and the aircraft's mark is drawn", () => {
    follow(level(0));
    sky.seen.flight = flying(null);
    sky.rig.set("cockpit", "flight");
    sky.picture();
    expect(sky.within).toBeNull();
    expect(sky.away_m).toBeCloseTo(45, 3);
  });

  test("leaves a level horizon, free hands and the usual view behind", () => {
    sky.seen.flight = flying({ yaw_deg: 200, pitch_deg: 8, roll_deg: -30 });
    sky.rig.set("cockpit", "flight");
    sky.picture();
    sky.rig.set("free", "flight");
    sky.picture();
    const [heading, pitch, roll] = sky.rig.attitude_deg;
    expect(heading).toBeCloseTo(200, 2);
    expect(pitch).toBeCloseTo(8, 2);
    expect(turn(0, roll)).toBeCloseTo(0, 6);
    expect(sky.controls.enableInputs).toBe(true);
    expect(sky.fov_deg).toBeCloseTo(60, 6);
    expect(sky.within).toBeNull();
  });
});

describe("the map's keys", () => {
  test("look around from where a free camera is", () => {
    const from = Cartesian3.clone(sky.camera.positionWC);
    sky.camera.setView({ orientation: { heading: CesiumMath.toRadians(90), pitch: 0, roll: 0 } });
    sky.rig.key("ArrowRight");
    expect(sky.heading_deg).toBeCloseTo(95, 3);
    sky.rig.key("ArrowLeft");
    sky.rig.key("ArrowLeft");
    expect(sky.heading_deg).toBeCloseTo(85, 3);
    sky.rig.key("ArrowUp");
    expect(sky.rig.attitude_deg[1]).toBeCloseTo(5, 3);
    sky.rig.key("ArrowDown");
    sky.rig.key("ArrowDown");
    expect(sky.rig.attitude_deg[1]).toBeCloseTo(-5, 3);
    expect(Cartesian3.distance(sky.camera.positionWC, from)).toBeLessThan(1e-6);
  });

  test("move a following camera around its aircraft", () => {
    follow(level(0));
    for (const key of ["ArrowLeft", "ArrowUp", "ArrowRight", "ArrowRight", "ArrowDown"]) {
      const before = Cartesian3.clone(sky.camera.positionWC);
      expect(sky.rig.key(key)).toBe(true);
      expect(Cartesian3.distance(sky.camera.positionWC, before)).toBeGreaterThan(1);
      expect(sky.away_m).toBeCloseTo(45, 3);
    }
  });

  test("go nearer by a sixth and back again", () => {
    follow(level(0));
    sky.rig.key("+");
    expect(sky.away_m).toBeCloseTo(45 / 1.2, 3);
    sky.rig.key("-");
    expect(sky.away_m).toBeCloseTo(45, 3);
  });

  test("bring a free camera nearer by its height", () => {
    const height_m = (): number => sky.camera.positionCartographic.height;
    expect(height_m()).toBeCloseTo(25_000, 3);
    sky.rig.key("+");
    expect(height_m()).toBeCloseTo(25_000 / 1.2, 0);
    sky.rig.key("-");
    expect(height_m()).toBeCloseTo(25_000, 0);
  });

  test("that mean nothing here are left to the page", () => {
    expect(sky.rig.key("x")).toBe(false);
  });
});

test("every change of the camera is shown", () => {
  sky.rig.set("free", "flight");
  sky.rig.key("ArrowLeft");
  expect(sky.asked).toBe(2);
});

test("a rig that is no longer used lets the camera go where it is", () => {
  follow(level(45));
  const before = Cartesian3.clone(sky.camera.positionWC);
  sky.rig.dispose();
  expect(sky.isHeard).toBe(false);
  expect(Cartesian3.distance(sky.camera.positionWC, before)).toBeLessThan(1e-3);
  // No longer in the aircraft's axes.
  expect(Cartesian3.equals(sky.camera.position, sky.camera.positionWC)).toBe(true);
});
