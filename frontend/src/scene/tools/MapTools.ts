import {
  BoundingSphere,
  Cartesian2,
  Cartesian3,
  Math as CesiumMath,
  HeadingPitchRange,
  Matrix4,
} from "@cesium/engine";
import { crossingSides } from "../../lib/fenceBorder";
import type { Position } from "../../lib/geodesy";
import { AREA, FENCE, WARNED } from "../colours";
import type { Globe } from "../globe/Globe";
import type { GroundPlace } from "../legs/target";
import { DistanceLine, type MeasuredPlace } from "./DistanceLine";
import { type MapPointer, pointerOf } from "./MapPointer";

/** The present scale and direction of the view. */
export interface MapScale {
  /** Heading of the camera, clockwise from north. */
  readonly heading_deg: number;
  /** Scale on the ground in the middle of the picture, horizontally; null without ground. */
  readonly metresPerPixel: number | null;
}

export type PlaceInSpace = Position & { readonly altitude_m: number };

/** Width over which the scale is measured, pixels. */
const SPAN_PX = 60;
/** Shortest time between reports of the scale. */
const SCALE_MS = 200;
/** Slope of the view of several points, and distance of the view of one. */
const PITCH_DEG = -50;
const NEAREST_M = 600;
/** The camera leaves an aircraft only in the picture after the command; it can be moved then. */
const PICTURES_TO_FREE = 2;

/** Scale, point under the pointer, distance line, and views of points. */
export class MapTools {
  readonly #globe: Globe;
  readonly #pointer: MapPointer;
  readonly #line: DistanceLine;
  readonly #area: DistanceLine;
  readonly #fence: DistanceLine;
  /** The two sides of the fence that cross. */
  readonly #crossing: readonly [DistanceLine, DistanceLine];
  readonly #warned: DistanceLine;
  readonly #ends: readonly (() => void)[];
  #onScale: ((scale: MapScale) => void) | null = null;
  #onMeasure: ((place: GroundPlace) => void) | null = null;
  #told_ms = 0;
  /** Whether the picture before this one was drawn: the first can take many seconds. */
  #hasDrawn = false;
  #wanted: { readonly sphere: BoundingSphere; pictures: number } | null = null;

  constructor(globe: Globe) {
    this.#globe = globe;
    this.#pointer = pointerOf(globe);
    this.#line = new DistanceLine(globe);
    this.#area = new DistanceLine(globe, AREA);
    this.#fence = new DistanceLine(globe, FENCE);
    this.#crossing = [new DistanceLine(globe, WARNED), new DistanceLine(globe, WARNED)];
    this.#warned = new DistanceLine(globe, WARNED);
    this.#ends = [
      globe.onBeforePicture((now_ms) => this.#beforePicture(now_ms)),
      this.#pointer.addFinder((at) => {
        const measure = this.#onMeasure;
        const place = measure === null ? null : this.#pointer.placeAt(at);
        return measure === null || place === null
          ? null
          : { cursor: "crosshair", click: () => measure(place), drag: null };
      }),
    ];
  }

  onHover(listener: (place: GroundPlace | null) => void): () => void {
    return this.#pointer.onHover(listener);
  }

  /** Not before the first picture is drawn. */
  onScale(listener: ((scale: MapScale) => void) | null): void {
    this.#onScale = listener;
  }

  /** The listener for clicked points; null: a click selects what is under it. */
  measure(listener: ((place: GroundPlace) => void) | null): void {
    this.#onMeasure = listener;
  }

  showDistance(places: readonly MeasuredPlace[]): void {
    this.#line.show(places);
  }

  /** The outline of an area; the caller closes it. */
  showArea(places: readonly MeasuredPlace[]): void {
    this.#area.show(places);
  }

  /** The fence's border; the caller closes it. */
  showFence(places: readonly MeasuredPlace[]): void {
    this.#fence.show(places);
    const sides = crossingSides(places.slice(0, -1));
    for (const [nth, line] of this.#crossing.entries()) {
      const side = sides?.[nth];
      line.show(side === undefined ? [] : places.slice(side, side + 2));
    }
  }

  /** The present track that is warned of. */
  showWarned(places: readonly MeasuredPlace[]): void {
    this.#warned.show(places);
  }

  /** The ground in the middle of the picture; null where there is sky. */
  centre(): GroundPlace | null {
    const { clientWidth, clientHeight } = this.#globe.scene.canvas;
    return this.#pointer.placeAt({ x: clientWidth / 2, y: clientHeight / 2 });
  }

  /** Look at all of these from above; the camera must be free. */
  lookAt(places: readonly PlaceInSpace[]): void {
    if (places.length > 0) {
      const points = places.map(({ longitude_deg, latitude_deg, altitude_m }) =>
        Cartesian3.fromDegrees(longitude_deg, latitude_deg, altitude_m),
      );
      this.#wanted = { sphere: BoundingSphere.fromPoints(points), pictures: PICTURES_TO_FREE };
      this.#globe.requestRender();
    }
  }

  /** Show this place in the middle, from as far and as steeply as what is there now; the camera must be free. */
  centreOn(place: GroundPlace): void {
    const { camera } = this.#globe.scene;
    this.#lookFrom(place, camera.heading, this.#range_m(this.centre()));
  }

  /** Turn about the middle of the picture until north is up. */
  northUp(): void {
    const { camera } = this.#globe.scene;
    const place = this.centre();
    if (place === null) {
      camera.setView({ orientation: { heading: 0, pitch: camera.pitch, roll: 0 } });
      this.#globe.requestRender();
    } else {
      this.#lookFrom(place, 0, this.#range_m(place));
    }
  }

  #lookFrom(place: GroundPlace, heading: number, range_m: number): void {
    const { camera } = this.#globe.scene;
    camera.lookAt(inSpace(place), new HeadingPitchRange(heading, camera.pitch, range_m));
    camera.lookAtTransform(Matrix4.IDENTITY);
    this.#globe.requestRender();
  }

  #range_m(place: GroundPlace | null): number {
    return place === null
      ? NEAREST_M
      : Cartesian3.distance(this.#globe.scene.camera.positionWC, inSpace(place));
  }

  dispose(): void {
    for (const end of this.#ends) {
      end();
    }
    this.#line.dispose();
    this.#area.dispose();
    this.#fence.dispose();
    for (const line of this.#crossing) line.dispose();
    this.#warned.dispose();
  }

  #beforePicture(now_ms: number): void {
    this.#look();
    const hasDrawn = this.#hasDrawn;
    this.#hasDrawn = true;
    if (hasDrawn && this.#onScale !== null && now_ms - this.#told_ms >= SCALE_MS) {
      this.#told_ms = now_ms;
      this.#onScale({
        heading_deg: CesiumMath.toDegrees(this.#globe.scene.camera.heading),
        metresPerPixel: this.#metresPerPixel(),
      });
    }
  }

  #look(): void {
    const wanted = this.#wanted;
    if (wanted === null) {
      return;
    }
    wanted.pictures -= 1;
    if (wanted.pictures <= 0) {
      this.#wanted = null;
      const { camera } = this.#globe.scene;
      const range = Math.max(NEAREST_M, 2.6 * wanted.sphere.radius);
      camera.viewBoundingSphere(
        wanted.sphere,
        new HeadingPitchRange(0, CesiumMath.toRadians(PITCH_DEG), range),
      );
      camera.lookAtTransform(Matrix4.IDENTITY);
    }
    this.#globe.requestRender();
  }

  #metresPerPixel(): number | null {
    const { camera, canvas } = this.#globe.scene;
    const [x, y] = [canvas.clientWidth / 2, canvas.clientHeight / 2];
    const left = camera.pickEllipsoid(new Cartesian2(x - SPAN_PX / 2, y));
    const right = camera.pickEllipsoid(new Cartesian2(x + SPAN_PX / 2, y));
    return left === undefined || right === undefined ? null : Cartesian3.distance(left, right) / SPAN_PX;
  }
}

function inSpace({ longitude_deg, latitude_deg, height_m }: GroundPlace): Cartesian3 {
  return Cartesian3.fromDegrees(longitude_deg, latitude_deg, height_m ?? 0);
}
