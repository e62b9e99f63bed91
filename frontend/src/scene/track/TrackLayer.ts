import { BoundingSphere, Cartesian3, Cartesian4, type PictureState } from "@cesium/engine";
import { Repeating } from "../../lib/repeating";
import { BROWSER_TIMERS, tellTiming } from "../../lib/timers";
import { METRES_PER_UNIT } from "../../lib/track/block";
import { ThinnedTrack } from "../../lib/track/thinnedTrack";
import type { WeightedBlock } from "../../lib/track/thinning";
import {
  COLOURINGS,
  type Colouring,
  rgb,
  SCALES,
  type Range as Scale,
  UNKNOWN_COLOUR,
} from "../../lib/track/trackColours";
import type { TrackPoints } from "../../lib/track/trackPoints";
import type { Globe } from "../globe/Globe";
import { downToTheSea, isWithin } from "../ribbon/ball";
import { Ribbon, type RibbonStyle } from "../ribbon/Ribbon";
import { type Range, rangesOf } from "../ribbon/ranges";
import { boundsOf } from "../ribbon/vertices";
import { type Eye, TrackBody } from "./body";
import { type Tip, TrackTail } from "./tail";

/** The style of a track on the globe: its own colour when values do not colour it, and its edge's. */
export interface TrackKind {
  readonly plain: string;
  readonly casing: string;
  /** Where two tracks overlap, the one with the greater rank is on top. */
  readonly rank: number;
}

export interface TrackLook {
  readonly colouring: Colouring;
  /** The values at the ends of the scale, metres or metres a second; null while unknown. */
  readonly range: Scale | null;
  readonly hasCurtain: boolean;
}

const CORE_PX = 3;
const WIDTH_PX = 5;
const CURTAIN_OPACITY = 0.3;
/**
 * Without a graphics processor, a moving picture has curtains only under this many of the newest complete blocks:
 * after hours of rounds, curtains overlap ten times in every pixel. At rest all are drawn.
 */
const CURTAIN_BLOCKS = 8;
/** Greatest deviation of a drawn line from the flown one, pixels. */
const STRAY_PX = 0.8;
const SOFTWARE_STRAY_PX = 1.6;
/** Share of its distance by which each rank brings a line nearer to the camera. */
const RANK_STEP = 0.002;
/** Time for computing levels of detail between two animation frames of the instruments. */
const SLICE_MS = 4;
const REST_MS = 12;
/** Time for choosing levels per picture; small errors wait for the next one. */
const CHOOSE_MS = 0.7;

/**
 * Tracks on the globe: each a line of complete blocks and one of the newest points, with a curtain down to sea level.
 */
export class TrackLayer {
  readonly #globe: Globe;
  readonly #drawn = new Map<TrackPoints, DrawnTrack>();
  readonly #endPictures: () => void;
  readonly #thinning = new Repeating(BROWSER_TIMERS, () => this.#thin(), REST_MS);
  #look: TrackLook = { colouring: "none", range: null, hasCurtain: true };

  constructor(globe: Globe) {
    this.#globe = globe;
    this.#endPictures = globe.onBeforePicture(() => this.#beforePicture());
    globe.scene.primitives.add(this.#primitive);
  }

  /** Add a track. */
  add(points: TrackPoints, kind: TrackKind): void {
    if (!this.#drawn.has(points)) {
      this.#drawn.set(points, new DrawnTrack(points, kind, () => this.#look));
      // Later ones are drawn on top.
      const inOrder = [...this.#drawn].sort(([, one], [, other]) => one.rank - other.rank);
      this.#drawn.clear();
      for (const [key, drawn] of inOrder) {
        this.#drawn.set(key, drawn);
      }
      this.#globe.requestRender();
    }
  }

  setLook(look: TrackLook): void {
    this.#look = look;
    this.#globe.requestRender();
  }

  /** Where a track's aircraft is drawn in this picture; null: it is not live. */
  setTip(points: TrackPoints, tip: Tip | null): void {
    const drawn = this.#drawn.get(points);
    if (drawn !== undefined) {
      drawn.tip = tip;
    }
  }

  setVisible(points: TrackPoints, isVisible: boolean): void {
    const drawn = this.#drawn.get(points);
    if (drawn !== undefined) {
      drawn.isVisible = isVisible;
      this.#globe.requestRender();
    }
  }

  /** A track that is not needed any more. */
  remove(points: TrackPoints): void {
    this.#drawn.get(points)?.destroy();
    if (this.#drawn.delete(points)) {
      this.#globe.requestRender();
    }
  }

  /** Number of points that are drawn. */
  get drawnPoints(): number {
    return [...this.#drawn.values()].reduce((sum, { count }) => sum + count, 0);
  }

  dispose(): void {
    this.#endPictures();
    this.#thinning.cancel();
    this.#globe.scene.primitives.remove(this.#primitive);
    this.#globe.requestRender();
  }

  #beforePicture(): void {
    for (const drawn of this.#drawn.values()) {
      if (drawn.hasNews) {
        this.#globe.requestRender();
      }
    }
  }

  /** While the picture is made: camera and aircraft are in their final places. */
  #update(state: PictureState): void {
    const { camera, drawingBufferHeight } = this.#globe.scene;
    const { x, y, z } = camera.positionWC;
    const fovy = (camera.frustum as { readonly fovy?: number }).fovy ?? 1;
    const pixel_rad = (2 * Math.tan(fovy / 2)) / Math.max(1, drawingBufferHeight);
    const stray_rad = pixel_rad * (this.#globe.isSoftware ? SOFTWARE_STRAY_PX : STRAY_PX);
    const eye = { x, y, z, stray_rad };
    const started_ms = performance.now();
    for (const drawn of this.#drawn.values()) {
      if (drawn.isVisible) {
        drawn.update(eye);
        drawn.draw(state, this.#curtainBlocks());
      }
    }
    tellTiming("track.update", started_ms);
    if (this.#isThinning()) {
      this.#thinning.arm(0);
    }
  }

  /** Number of newest complete blocks with a curtain. */
  #curtainBlocks(): number {
    if (!this.#look.hasCurtain) {
      return 0;
    }
    return this.#globe.isSoftware && this.#globe.isMoving ? CURTAIN_BLOCKS : Number.POSITIVE_INFINITY;
  }

  #isThinning(): boolean {
    return [...this.#drawn.values()].some(({ isVisible, isThinned }) => isVisible && !isThinned);
  }

  /** Long tracks that arrive at once are thinned apart from the pictures, which are few on slow graphics. */
  #thin(): number | null {
    const end_ms = performance.now() + SLICE_MS;
    for (const drawn of this.#drawn.values()) {
      if (drawn.isVisible && drawn.thin(end_ms)) {
        this.#globe.requestRender();
      }
    }
    return this.#isThinning() ? REST_MS : null;
  }

  /** The primitive that the engine asks for draw commands for each picture. */
  readonly #primitive = {
    update: (state: PictureState): void => {
      if (state.passes.render) {
        this.#update(state);
      }
    },
    isDestroyed: (): boolean => false,
    destroy: (): void => {
      for (const drawn of this.#drawn.values()) {
        drawn.destroy();
      }
      this.#drawn.clear();
    },
  };
}

class DrawnTrack {
  tip: Tip | null = null;
  isVisible = true;
  readonly rank: number;
  readonly #points: TrackPoints;
  #revision = -1;
  readonly #thinned: ThinnedTrack;
  readonly #body: TrackBody;
  readonly #tail: TrackTail;
  readonly #ribbons: { readonly body: Ribbon; readonly tail: Ribbon };
  readonly #made = new WeakMap<WeightedBlock, BoundingSphere>();
  /** The spheres of these blocks, in their order. */
  #balls: readonly BoundingSphere[] = [];
  #enclosed: readonly WeightedBlock[] = [];
  readonly #spheres = { body: new BoundingSphere(), tail: new BoundingSphere() };

  constructor(points: TrackPoints, kind: TrackKind, look: () => TrackLook) {
    this.rank = kind.rank;
    this.#points = points;
    this.#thinned = new ThinnedTrack(points);
    this.#body = new TrackBody(this.#thinned);
    this.#tail = new TrackTail(points);
    const style = styleOf(kind, look);
    this.#ribbons = {
      body: new Ribbon(style, this.#spheres.body),
      tail: new Ribbon(style, this.#spheres.tail),
    };
  }

  get count(): number {
    return this.#body.count + this.#tail.count;
  }

  /** There are points that are not drawn yet. */
  get hasNews(): boolean {
    return this.isVisible && (this.#points.revision !== this.#revision || !this.#body.isComplete);
  }

  /** Whether every complete block has its levels of detail. */
  get isThinned(): boolean {
    return this.#thinned.isComplete;
  }

  /** Computes levels of detail until then, at least one. Returns whether more can be drawn now. */
  thin(end_ms: number): boolean {
    let made = 0;
    return this.#thinned.refresh(() => made++ > 0 && performance.now() > end_ms);
  }

  /** Updates for this camera, up to the newest complete block: there is no gap before the tail. */
  update(eye: Eye): void {
    this.#revision = this.#points.revision;
    let made = 0;
    this.#thinned.refresh(() => made++ > 0);
    const end_ms = performance.now() + CHOOSE_MS;
    if (this.#body.choose(eye, () => performance.now() > end_ms)) {
      this.#ribbons.body.set(this.#body.vertices, this.#body.count, this.#body.changed);
    }
    if (this.#body.blocks !== this.#enclosed) {
      this.#enclosed = this.#body.blocks;
      this.#balls = this.#enclosed.map((block) => this.#ballOf(block));
      BoundingSphere.fromBoundingSpheres([...this.#balls], this.#spheres.body);
    }
    if (this.#tail.update(this.tip)) {
      this.#ribbons.tail.set(this.#tail.vertices, this.#tail.count, this.#tail.changed);
      downToTheSea(boundsOf(this.#tail.vertices, this.#tail.count), this.#spheres.tail);
    }
  }

  /** `curtainBlocks`: number of newest complete blocks with a curtain; 0: no curtain at all. */
  draw(state: PictureState, curtainBlocks: number): void {
    const { body, tail } = this.#ribbons;
    const { starts, count } = this.#body;
    const seen = this.#balls.map((ball) => isWithin(ball, state.cullingVolume));
    const rangesFrom = (first: number): readonly Range[] =>
      rangesOf(starts, count, (index) => index >= first && seen[index] === true);
    body.draw(state, "line", rangesFrom(0));
    tail.draw(state, "line");
    if (curtainBlocks > 0) {
      // Of overlapping curtains the one drawn first is visible: the newest.
      tail.draw(state, "curtain");
      body.draw(state, "curtain", rangesFrom(this.#balls.length - curtainBlocks));
    }
  }

  destroy(): void {
    this.#ribbons.body.destroy();
    this.#ribbons.tail.destroy();
  }

  #ballOf(thinned: WeightedBlock): BoundingSphere {
    const made = this.#made.get(thinned);
    if (made !== undefined) {
      return made;
    }
    const { block, centre, radius_m } = thinned;
    const top_m = block.altitude_mm.reduce((one, other) => Math.max(one, other)) * METRES_PER_UNIT;
    const ball = downToTheSea({ centre, radius_m, top_m });
    this.#made.set(thinned, ball);
    return ball;
  }
}

function styleOf({ plain, casing, rank }: TrackKind, look: () => TrackLook): RibbonStyle {
  const scale = new Cartesian4();
  const scaleNow = (opacity: number) => (): Cartesian4 => {
    const { colouring, range } = look();
    const by = range === null ? 0 : COLOURINGS.indexOf(colouring);
    return Cartesian4.fromElements(by, range?.least ?? 0, range?.most ?? 1, opacity, scale);
  };
  const vector = (colour: string): Cartesian3 => new Cartesian3(...rgb(colour));
  const [own, edge, unknown] = [vector(plain), vector(casing), vector(UNKNOWN_COLOUR)];
  const scales = new Map(
    COLOURINGS.map((name) => [name, SCALES[name === "none" ? "height" : name].map(vector)] as const),
  );
  const colours = {
    u_scale: scaleNow(1),
    u_plain: () => own,
    u_unknown: () => unknown,
    u_nearer: () => 1 - rank * RANK_STEP,
    u_colours: () => scales.get(look().colouring),
  };
  return {
    line: {
      ...colours,
      u_width: () => WIDTH_PX,
      u_core: () => CORE_PX,
      u_edge: () => edge,
      u_opacity: () => 1,
    },
    isDashed: false,
    isTranslucent: false,
    curtain: { uniforms: { ...colours, u_scale: scaleNow(CURTAIN_OPACITY) }, veil: 1 << rank },
  };
}
