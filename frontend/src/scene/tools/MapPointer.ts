import { Cartesian2, Cartographic, Math as CesiumMath, EllipsoidTerrainProvider } from "@cesium/engine";
import { GuardedCalls } from "../../lib/guardedCalls";
import type { Globe } from "../globe/Globe";
import type { Spot } from "../legs/geometry";
import { type GroundPlace, REACH_PX, reachOf } from "../legs/target";
import { type GestureHands, Gestures } from "./Gestures";

/** Something that is being dragged. */
export interface Drag {
  move(at: Spot, isShift: boolean): void;
  drop(): void;
  cancel(): void;
}

/** Something under the pointer that can be clicked or dragged. */
export interface Grip {
  readonly cursor: string;
  /** `isMore`: with Shift, Ctrl or Command, which adds to what is selected. */
  readonly click: (isMore: boolean) => void;
  /** Starts a drag at the pointer; null if it cannot be dragged. */
  readonly drag: ((from: Spot, isShift: boolean) => Drag | null) | null;
}

type Finder = (at: Spot, reach_px: number) => Grip | null;

/** Movement up to this many pixels is a click, not a drag. */
const CLICK_PX = 4;
/** Shortest time between reports of the point under the pointer. */
const HOVER_MS = 100;

const pointers = new WeakMap<Globe, MapPointer>();

/** The one pointer of a globe, shared by all that draw on it. */
export function pointerOf(globe: Globe): MapPointer {
  const pointer = pointers.get(globe) ?? new MapPointer(globe);
  pointers.set(globe, pointer);
  return pointer;
}

/**
 * The pointer's actions on the globe besides turning it. A press on something with a grip does not reach the camera;
 * every other press does. Lives as long as the globe.
 */
export class MapPointer {
  readonly #globe: Globe;
  readonly #canvas: HTMLCanvasElement;
  readonly #finders: Finder[] = [];
  readonly #last = new Set<Finder>();
  readonly #hovers = new Set<(place: GroundPlace | null) => void>();
  readonly #gestures = new Set<GestureHands>();
  readonly #calls = new GuardedCalls((error) => reportError(error));
  readonly #cursors = new Set<() => string>();
  #grip: Grip | null = null;
  #drag: Drag | null = null;
  #down: Spot | null = null;
  #hovered_ms = 0;

  constructor(globe: Globe) {
    this.#globe = globe;
    this.#canvas = globe.scene.canvas;
    // Captured at the canvas itself, before the camera's listeners.
    const options = { capture: true };
    new Gestures(this.#canvas, {
      // What can be taken hold of is clicked as such.
      tap: (at) => this.#find(at) === null && this.#gesture((hands) => hands.tap(at)),
      double: (at) => this.#find(at) === null && this.#gesture((hands) => hands.double(at)),
      menu: (at, isFinger) => {
        this.#end((drag) => drag.cancel());
        this.#gesture((hands) => hands.menu(at, isFinger));
      },
    });
    this.#canvas.addEventListener("pointerdown", this.#press, options);
    this.#canvas.addEventListener("pointermove", this.#move, options);
    this.#canvas.addEventListener("pointerup", this.#lift, options);
    this.#canvas.addEventListener("pointercancel", () => this.#end((drag) => drag.cancel()), options);
    this.#canvas.addEventListener("pointerleave", () => this.#tell(null), options);
    window.addEventListener("keydown", this.#key, options);
  }

  /** Add a finder of things under the pointer; later ones are asked first. */
  addFinder(finder: Finder): () => void {
    this.#finders.unshift(finder);
    return () => {
      const at = this.#finders.indexOf(finder);
      if (at >= 0) {
        this.#finders.splice(at, 1);
      }
    };
  }

  /** Add a finder that is asked after all others: for things of the ground. */
  addLastFinder(finder: Finder): () => void {
    this.#last.add(finder);
    return () => this.#last.delete(finder);
  }

  /** Report taps on the ground, double taps, and what asks for a menu. */
  onGesture(hands: GestureHands): () => void {
    this.#gestures.add(hands);
    return () => this.#gestures.delete(hands);
  }

  /** The pointer's look over bare ground; "": the usual one. */
  onCursor(cursor: () => string): () => void {
    this.#cursors.add(cursor);
    return () => this.#cursors.delete(cursor);
  }

  /** Report the point under the pointer; null when it leaves the ground. */
  onHover(listener: (place: GroundPlace | null) => void): () => void {
    this.#hovers.add(listener);
    return () => this.#hovers.delete(listener);
  }

  /** The point on the ground at a spot of the canvas; null in the sky. */
  placeAt(at: Spot): GroundPlace | null {
    const { scene } = this.#globe;
    const hasTerrain = !(scene.terrainProvider instanceof EllipsoidTerrainProvider);
    const spot = new Cartesian2(at.x, at.y);
    const ray = scene.camera.getPickRay(spot);
    // Without terrain, the drawn tiles only approximate the ellipsoid; the ellipsoid itself is exact.
    const point =
      hasTerrain && ray !== undefined ? scene.globe.pick(ray, scene) : scene.camera.pickEllipsoid(spot);
    const place = point === undefined ? undefined : Cartographic.fromCartesian(point);
    return place === undefined
      ? null
      : {
          latitude_deg: CesiumMath.toDegrees(place.latitude),
          longitude_deg: CesiumMath.toDegrees(place.longitude),
          height_m: hasTerrain ? place.height : null,
        };
  }

  #groundCursor(): string {
    return [...this.#cursors].map((cursor) => cursor()).find((cursor) => cursor !== "") ?? "";
  }

  #gesture(tell: (hands: GestureHands) => void): void {
    this.#calls.each(this.#gestures, tell);
  }

  #find(at: Spot, reach_px: number = REACH_PX.mouse): Grip | null {
    for (const finder of [...this.#finders, ...this.#last]) {
      const grip = finder(at, reach_px);
      if (grip !== null) {
        return grip;
      }
    }
    return null;
  }

  #tell(place: GroundPlace | null): void {
    this.#calls.each(this.#hovers, (listener) => listener(place));
  }

  readonly #press = (event: PointerEvent): void => {
    if (event.button !== 0 || !event.isPrimary) {
      return;
    }
    const at = spotOf(event);
    this.#down = at;
    this.#grip = this.#find(at, reachOf(event.pointerType));
    if (this.#grip !== null) {
      event.stopImmediatePropagation();
      event.preventDefault();
      this.#canvas.setPointerCapture(event.pointerId);
    }
  };

  readonly #move = (event: PointerEvent): void => {
    const at = spotOf(event);
    if (this.#grip !== null && this.#down !== null) {
      event.stopImmediatePropagation();
      if (this.#drag === null && away(at, this.#down) > CLICK_PX) {
        this.#drag = this.#grip.drag?.(this.#down, event.shiftKey) ?? null;
      }
      this.#drag?.move(at, event.shiftKey);
      return;
    }
    if (event.buttons === 0 && event.timeStamp - this.#hovered_ms >= HOVER_MS) {
      this.#hovered_ms = event.timeStamp;
      this.#canvas.style.cursor = this.#find(at)?.cursor ?? this.#groundCursor();
      if (this.#hovers.size > 0) {
        this.#tell(this.placeAt(at));
      }
    }
  };

  readonly #lift = (event: PointerEvent): void => {
    const grip = this.#grip;
    if (grip === null || event.button !== 0) {
      return;
    }
    event.stopImmediatePropagation();
    const isPress = this.#drag === null && this.#down !== null && away(spotOf(event), this.#down) <= CLICK_PX;
    this.#end((drag) => drag.drop());
    if (isPress) {
      grip.click(event.shiftKey || event.ctrlKey || event.metaKey);
    }
  };

  readonly #key = (event: KeyboardEvent): void => {
    if (event.key === "Escape" && this.#drag !== null) {
      event.stopImmediatePropagation();
      this.#end((drag) => drag.cancel());
    }
  };

  #end(how: (drag: Drag) => void): void {
    const drag = this.#drag;
    this.#drag = null;
    this.#grip = null;
    this.#down = null;
    if (drag !== null) {
      how(drag);
    }
  }
}

function spotOf({ offsetX, offsetY }: PointerEvent): Spot {
  return { x: offsetX, y: offsetY };
}

function away(one: Spot, other: Spot): number {
  return Math.hypot(one.x - other.x, one.y - other.y);
}
