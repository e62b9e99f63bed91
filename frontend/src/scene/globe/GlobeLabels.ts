import { Cartesian3, type Scene } from "@cesium/engine";
import type { Spot } from "../../lib/labels";
import { LabelSheet, type ShownText } from "../labels/LabelSheet";
import type { Light } from "../look";
import { Projector } from "./Projector";
import { type Horizon, horizonThrough, paintHaze, paintSky } from "./sky";

/** A text beside a point in space. */
export interface SpaceText extends Omit<ShownText, "at"> {
  readonly position: Cartesian3;
}

/** Writes texts of the next picture; asked before each. */
export type Writer = (project: Projector, width_px: number, height_px: number) => readonly ShownText[];

/** The sky is so much coarser than the page: it has no edges. */
const SKY_SCALE = 1 / 4;
/** To both sides of where the camera looks, the horizon is looked for. */
const SIDE_RAD = 0.45;
const ALL_ROUND_RAD = 2.1;
const STEEP_RAD = -1;

/**
 * What lies over and under the globe's picture on canvases of its own: all texts, so that no two lie over each other;
 * the air before the ground; and the sky behind it.
 */
export class GlobeLabels {
  readonly #scene: Scene;
  readonly #over = document.createElement("canvas");
  readonly #under = document.createElement("canvas");
  readonly #sheet = new LabelSheet();
  readonly #projector = new Projector();
  readonly #owned = new Map<object, readonly SpaceText[]>();
  readonly #writers = new Set<Writer>();
  #light: Light = "day";
  #horizon: Horizon | null = null;
  #degree_px = 1;
  #height_m = 0;

  constructor(scene: Scene, host: HTMLElement) {
    this.#scene = scene;
    this.#over.className = "globe-labels";
    this.#under.className = "globe-sky";
    host.append(this.#over);
    host.prepend(this.#under);
  }

  setLight(light: Light): void {
    this.#light = light;
  }

  /** The texts of one that draws on the globe, in place of its last ones. */
  show(owner: object, texts: readonly SpaceText[]): void {
    if (texts.length === 0) {
      this.#owned.delete(owner);
    } else {
      this.#owned.set(owner, texts);
    }
  }

  addWriter(writer: Writer): () => void {
    this.#writers.add(writer);
    return () => this.#writers.delete(writer);
  }

  /** The shown text under a spot of the picture. */
  find(at: Spot, reach_px: number): string | null {
    return this.#sheet.find(at, reach_px);
  }

  /** Place everything for the camera as it is: called with each picture. */
  arrange(): void {
    const { camera, canvas } = this.#scene;
    const { clientWidth: width, clientHeight: height } = canvas;
    if (width === 0 || height === 0) {
      return;
    }
    this.#projector.set(camera, width, height);
    const texts: ShownText[] = [];
    for (const owned of this.#owned.values()) {
      for (const { position, ...text } of owned) {
        const at = this.#projector.ground(position);
        if (at !== null) {
          texts.push({ ...text, at });
        }
      }
    }
    for (const write of this.#writers) {
      texts.push(...write(this.#projector, width, height));
    }
    this.#sheet.arrange(texts, width, height, window.devicePixelRatio || 1);
    this.#findHorizon(width, height);
  }

  /** Show what was arranged: when its picture is seen. */
  paint(): void {
    const { clientWidth: width, clientHeight: height } = this.#scene.canvas;
    const ratio = window.devicePixelRatio || 1;
    const sky = resized(this.#under, width, height, SKY_SCALE);
    if (sky !== null) {
      paintSky(
        sky,
        scaled(this.#horizon, SKY_SCALE),
        this.#degree_px * SKY_SCALE,
        this.#height_m,
        this.#light,
      );
    }
    const over = resized(this.#over, width, height, ratio);
    if (over !== null) {
      over.setTransform(ratio, 0, 0, ratio, 0, 0);
      over.clearRect(0, 0, width, height);
      if (this.#horizon !== null) {
        paintHaze(over, this.#horizon, this.#degree_px, this.#height_m, this.#light);
      }
      this.#sheet.paint(over);
    }
  }

  #findHorizon(width: number, height: number): void {
    const { camera } = this.#scene;
    const eye = camera.positionWC;
    const far = Cartesian3.magnitude(eye);
    const up = Cartesian3.normalize(eye, new Cartesian3());
    // The ellipsoid is not a sphere: the ground below the camera is what the horizon is that of.
    const height_m = Math.max(2, camera.positionCartographic.height);
    const radius = far - height_m;
    const cosine = radius / far;
    const ahead = Cartesian3.subtract(
      camera.directionWC,
      Cartesian3.multiplyByScalar(up, Cartesian3.dot(camera.directionWC, up), new Cartesian3()),
      new Cartesian3(),
    );
    this.#height_m = height_m;
    this.#degree_px = degreePx(this.#scene, height);
    if (Cartesian3.magnitude(ahead) < 1e-6) {
      Cartesian3.clone(camera.upWC, ahead);
    }
    Cartesian3.normalize(ahead, ahead);
    const side = Cartesian3.cross(ahead, up, new Cartesian3());
    const turn = camera.pitch < STEEP_RAD ? ALL_ROUND_RAD : SIDE_RAD;
    const at = (angle: number): Spot | null => {
      const out = radius * Math.sqrt(1 - cosine * cosine);
      const point = Cartesian3.multiplyByScalar(up, radius * cosine, new Cartesian3());
      for (const [axis, share] of [
        [ahead, Math.cos(angle)],
        [side, Math.sin(angle)],
      ] as const) {
        Cartesian3.add(point, Cartesian3.multiplyByScalar(axis, out * share, new Cartesian3()), point);
      }
      return this.#projector.spot(point);
    };
    const below = this.#projector.spot(Cartesian3.multiplyByScalar(up, radius, new Cartesian3()));
    this.#horizon = horizonThrough([at(0), at(-turn), at(turn)], below ?? { x: width / 2, y: 10 * height });
  }
}

function degreePx({ camera }: Scene, height: number): number {
  const { fovy } = camera.frustum as unknown as { readonly fovy?: number };
  return height / (((fovy ?? Math.PI / 3) * 180) / Math.PI);
}

function scaled(horizon: Horizon | null, by: number): Horizon | null {
  return (
    horizon && {
      middle: { x: horizon.middle.x * by, y: horizon.middle.y * by },
      radius_px: horizon.radius_px * by,
    }
  );
}

function resized(
  canvas: HTMLCanvasElement,
  width: number,
  height: number,
  ratio: number,
): CanvasRenderingContext2D | null {
  const [wide, high] = [Math.max(1, Math.round(width * ratio)), Math.max(1, Math.round(height * ratio))];
  if (canvas.width !== wide || canvas.height !== high) {
    [canvas.width, canvas.height] = [wide, high];
  }
  return canvas.getContext("2d");
}
