import type { PickedAirfield } from "../../lib/aircraft";
import type { Position } from "../../lib/geodesy";
import type { LabelBox } from "../../lib/labels";
import type { TrackPoints } from "../../lib/track/trackPoints";
import { AREA } from "../colours";
import type { CompassLetters } from "../globe/chart/graticule";
import { LabelSheet } from "../labels/LabelSheet";
import type { GroundPlace } from "../legs/target";
import { type MapTarget, REACH_PX } from "../legs/target";
import type { Light } from "../look";
import { NamedThings } from "../names/NamedThings";
import { type CountryNames, textOf } from "../names/thingTexts";
import type { Grip } from "../tools/MapPointer";
import { keptVectors, type World } from "../world/World";
import { FlatFence } from "./FlatFence";
import { FlatGround, nameLevel } from "./FlatGround";
import { FlatPlans } from "./FlatPlans";
import { FlatPointer } from "./FlatPointer";
import { type FlatLayer, FlatTiles } from "./FlatTiles";
import { FlatTrack, type FlatTrackLook } from "./FlatTrack";
import { FlatVector } from "./FlatVector";
import { drawGraticule } from "./flatGraticule";
import { drawAircraft, drawDistance, type FlatAircraft, type MarkedPlace } from "./flatThings";
import {
  around,
  type FlatView,
  fromScreen,
  metresPerPixel,
  panned,
  type ScreenPoint,
  toScreen,
  zoomed,
} from "./projection";
import { Words } from "./Words";

/** What lies on the map and does not move. */
export interface FlatContents {
  /** From below. */
  readonly layers: readonly FlatLayer[];
  /** From below. */
  readonly tracks: ReadonlyArray<{ readonly points: TrackPoints; readonly look: FlatTrackLook }>;
  /** Null: no lines of latitude and longitude. */
  readonly graticule: CompassLetters | null;
  readonly light: Light;
  readonly countries: CountryNames;
}

export interface FlatListener {
  /** Another part of the Earth is seen, or in another size. */
  readonly onView: (view: FlatView) => void;
  /** The place under the pointer; null: it is not over the map. */
  readonly onPointer: (place: Position | null) => void;
  /** A person has moved the map away from what it followed. */
  readonly onMoved: () => void;
  readonly onAirfield: (picked: PickedAirfield) => void;
}

const START: Position = { latitude_deg: 27.93, longitude_deg: -15.38 };
const START_ZOOM = 12;
const KEY_PX = 80;

const KEYS: Readonly<Record<string, (view: FlatView) => FlatView>> = {
  ArrowLeft: (view) => panned(view, -KEY_PX, 0),
  ArrowRight: (view) => panned(view, KEY_PX, 0),
  ArrowUp: (view) => panned(view, 0, -KEY_PX),
  ArrowDown: (view) => panned(view, 0, KEY_PX),
  "+": (view) => zoomed(view, 1, middleOf(view)),
  "-": (view) => zoomed(view, -1, middleOf(view)),
};

/** The map on a plain canvas, north up: for browsers without WebGL, and by choice. It is drawn only when something has changed. */
export class FlatScene {
  readonly plans = new FlatPlans(() => this.#change());
  readonly fence = new FlatFence(() => this.#change());
  readonly #canvas: HTMLCanvasElement;
  readonly #listener: FlatListener;
  readonly #pointer: FlatPointer;
  readonly #tiles = new FlatTiles(() => this.#change());
  readonly #vector = new FlatVector(keptVectors, () => this.#change());
  readonly #ground: FlatGround;
  readonly #names: NamedThings;
  readonly #sheet = new LabelSheet();
  /** A track that nobody shows any more goes with its points. */
  readonly #tracks = new WeakMap<TrackPoints, FlatTrack>();
  readonly #sizes: ResizeObserver;
  #view: FlatView = { centre: START, zoom: START_ZOOM, width_px: 0, height_px: 0 };
  #contents: FlatContents = {
    layers: [],
    tracks: [],
    graticule: null,
    light: "day",
    countries: (code) => code,
  };
  #aircraft: readonly FlatAircraft[] = [];
  #followed: Position | null = null;
  #measured: readonly MarkedPlace[] = [];
  #area: readonly MarkedPlace[] = [];
  #isAiming = false;
  #covered: readonly LabelBox[] = [];
  /** What is to be shown once the canvas has a size. */
  #awaited: readonly Position[] | null = null;
  #onMeasure: ((place: GroundPlace) => void) | null = null;
  #handle: number | null = null;

  constructor(canvas: HTMLCanvasElement, world: World, listener: FlatListener) {
    this.#canvas = canvas;
    this.#listener = listener;
    this.#ground = new FlatGround(world, () => this.#change());
    this.#names = new NamedThings(world, () => this.#change());
    this.#pointer = new FlatPointer(canvas, {
      find: (at, reach_px) => this.#find(at, reach_px),
      cursor: () => (this.#isAiming ? "crosshair" : ""),
      tap: (at) => this.plans.tell("tap", this.#view, at, this.#aircraft),
      double: (at) => this.plans.tell("double", this.#view, at, this.#aircraft),
      menu: (at, isFinger) =>
        this.plans.tell("menu", this.#view, at, this.#aircraft, isFinger ? REACH_PX.touch : REACH_PX.mouse),
      pan: (right_px, down_px) => {
        listener.onMoved();
        this.#look(panned(this.#view, right_px, down_px));
      },
      zoom: (steps, at) =>
        this.#look(zoomed(this.#view, steps, this.#followed === null ? at : middleOf(this.#view))),
      hover: (at) => listener.onPointer(at === null ? null : fromScreen(this.#view, at)),
    });
    this.#sizes = new ResizeObserver(() => this.#size());
    this.#sizes.observe(canvas);
    this.#size();
  }

  setContents(contents: FlatContents): void {
    this.#contents = contents;
    this.#ground.setLight(contents.light);
    this.#change();
  }

  /** Where the aircraft are now; `followed` stays in the middle. Draws also what the tracks have got meanwhile. */
  setAircraft(aircraft: readonly FlatAircraft[], followed: Position | null): void {
    const isSame = JSON.stringify([aircraft, followed]) === JSON.stringify([this.#aircraft, this.#followed]);
    this.#aircraft = aircraft;
    this.#followed = followed;
    if (!isSame && followed !== null) {
      this.#look({ ...this.#view, centre: followed });
    } else if (!isSame || this.#contents.tracks.some(({ points }) => this.#trackOf(points).hasNews)) {
      this.#change();
    }
  }

  /** What lies over the picture, CSS pixels from its upper left corner: no text is put there. */
  setCovered(covered: readonly LabelBox[]): void {
    this.#covered = covered;
    this.#change();
  }

  /** Whether a tap on the ground puts something there: the pointer shows it. */
  aim(isAiming: boolean): void {
    this.#isAiming = isAiming;
  }

  /** What lies at a spot of the canvas. */
  targetAt(at: ScreenPoint): MapTarget {
    return this.plans.targetAt(this.#view, at, this.#aircraft);
  }

  /** Who takes the places that are pressed; null: a press is for what lies under it. */
  measure(listener: ((place: GroundPlace) => void) | null): void {
    this.#onMeasure = listener;
  }

  showDistance(places: readonly MarkedPlace[]): void {
    this.#measured = places;
    this.#change();
  }

  /** The outline of an area; the caller closes it. */
  showArea(places: readonly MarkedPlace[]): void {
    this.#area = places;
    this.#change();
  }

  /** The ground in the middle of the picture. */
  centre(): GroundPlace {
    return { ...this.#view.centre, height_m: null };
  }

  zoom(steps: number): void {
    this.#look(zoomed(this.#view, steps, middleOf(this.#view)));
  }

  lookAt(places: readonly Position[]): void {
    if (this.#view.width_px > 0 && this.#view.height_px > 0) {
      this.#look(around(this.#view, places));
    } else {
      this.#awaited = places;
    }
  }

  /** Show this place in the middle, as large as before. */
  centreOn(centre: Position): void {
    this.#look({ ...this.#view, centre });
  }

  /** True: the key means something here. */
  key(key: string): boolean {
    const turn = KEYS[key];
    if (turn === undefined) {
      return false;
    }
    if (key.startsWith("Arrow")) {
      this.#listener.onMoved();
    }
    this.#look(turn(this.#view));
    return true;
  }

  dispose(): void {
    this.#pointer.dispose();
    this.#sizes.disconnect();
    this.#tiles.clear();
    this.#vector.clear();
    this.#ground.clear();
    this.#names.dispose();
    if (this.#handle !== null) {
      cancelAnimationFrame(this.#handle);
    }
  }

  #find(at: ScreenPoint, reach_px: number): Grip | null {
    const measure = this.#onMeasure;
    return measure === null
      ? (this.plans.find(() => this.#view, at, this.#aircraft, reach_px) ??
          this.fence.find(() => this.#view, at, reach_px) ??
          this.#findAirfield(at, reach_px))
      : {
          cursor: "crosshair",
          click: () => measure({ ...fromScreen(this.#view, at), height_m: null }),
          drag: null,
        };
  }

  #findAirfield(at: ScreenPoint, reach_px: number): Grip | null {
    const key = this.#sheet.find(at, reach_px);
    const thing = this.#names.things.find((one) => one.key === key);
    if (thing?.kind !== "airfield") {
      return null;
    }
    const { code, latitude_deg, longitude_deg } = thing.airfield;
    const click = (): void => this.#listener.onAirfield({ code, latitude_deg, longitude_deg });
    return { cursor: "pointer", click, drag: null };
  }

  #size(): void {
    const { clientWidth, clientHeight } = this.#canvas;
    const ratio = window.devicePixelRatio || 1;
    this.#canvas.width = Math.max(1, Math.round(clientWidth * ratio));
    this.#canvas.height = Math.max(1, Math.round(clientHeight * ratio));
    this.#look({ ...this.#view, width_px: clientWidth, height_px: clientHeight });
    if (this.#awaited !== null && clientWidth > 0 && clientHeight > 0) {
      const places = this.#awaited;
      this.#awaited = null;
      this.lookAt(places);
    }
  }

  #look(view: FlatView): void {
    this.#view = view;
    this.#listener.onView(view);
    this.#change();
  }

  #change(): void {
    this.#handle ??= requestAnimationFrame(() => {
      this.#handle = null;
      this.#draw();
    });
  }

  #draw(): void {
    const context = this.#canvas.getContext("2d");
    if (context === null) {
      return;
    }
    const { layers, tracks, graticule } = this.#contents;
    const ratio = window.devicePixelRatio || 1;
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    const words = new Words();
    this.#ground.draw(context, this.#view, ratio);
    this.#tiles.draw(context, this.#view, layers, (layer) =>
      this.#vector.draw(context, this.#view, layer, this.#contents.light),
    );
    if (graticule !== null) {
      drawGraticule(context, this.#view, graticule, words);
    }
    this.#name(words);
    for (const { points, look } of tracks) {
      const track = this.#trackOf(points);
      track.draw(context, this.#view, look);
      if (!track.isComplete) {
        this.#change();
      }
    }
    this.plans.draw(context, this.#view, words);
    this.fence.draw(context, this.#view, words);
    drawDistance(context, this.#view, this.#area, words, AREA);
    drawDistance(context, this.#view, this.#measured, words);
    for (const aircraft of this.#aircraft) {
      drawAircraft(context, this.#view, aircraft, words);
    }
    words.paint(context, this.#sheet, this.#view.width_px, this.#view.height_px, ratio, this.#covered);
  }

  /** What the ground's things are called. */
  #name(words: Words): void {
    const view = this.#view;
    const { light, countries } = this.#contents;
    const pixel_m = metresPerPixel(view);
    const half_m = (pixel_m * Math.hypot(view.width_px, view.height_px)) / 2;
    if (half_m > 0) {
      this.#names.see({
        centre: view.centre,
        sight_m: 2 * half_m,
        zones: [{ level: nameLevel(view), from_m: 0, to_m: 1.4 * half_m }],
      });
    }
    for (const name of this.#vector.takeNames()) {
      words.add(name);
    }
    for (const thing of this.#names.things) {
      words.add(textOf(thing, toScreen(view, thing), light, countries));
    }
  }

  #trackOf(points: TrackPoints): FlatTrack {
    const known = this.#tracks.get(points) ?? new FlatTrack(points);
    this.#tracks.set(points, known);
    return known;
  }
}

function middleOf(view: FlatView): ScreenPoint {
  return { x: view.width_px / 2, y: view.height_px / 2 };
}
