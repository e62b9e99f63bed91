import {
  Cartesian2,
  Cartesian3,
  Cartographic,
  Math as CesiumMath,
  EllipsoidTerrainProvider,
} from "@cesium/engine";
import type { PickedAirfield } from "../../lib/aircraft";
import type { Position } from "../../lib/geodesy";
import { type CompassLetters, nameAngles } from "../globe/chart/graticule";
import type { Globe } from "../globe/Globe";
import type { Projector } from "../globe/Projector";
import type { ShownText } from "../labels/LabelSheet";
import { GRATICULE_TEXT } from "../lettering";
import type { Light } from "../look";
import { pointerOf } from "../tools/MapPointer";
import type { NamedThing, NamedZone } from "../world/things";
import { levelFor } from "../world/tiling";
import { keptWorld } from "../world/World";
import { NamedThings, type Sight } from "./NamedThings";
import { type CountryNames, textOf } from "./thingTexts";

/** Names come from the finest level within this many metres, from the middle one within those. */
const NEAR_M = 170_000;
const REGION_M = 1_700_000;
/** The ground in the middle of what is ahead, as a share of the picture's height. */
const LOOKED_AT = 0.6;
const REACH_PX = 14;
/** Heights of so many things are looked up for each picture. */
const HEIGHTS_A_PICTURE = 6;

interface PlacedName {
  readonly thing: NamedThing;
  position: Cartesian3;
}

/** The names of the ground's things on the globe, and what a press on an airfield does. */
export class GlobeNames {
  readonly #globe: Globe;
  readonly #names: NamedThings;
  readonly #ends: readonly (() => void)[];
  #placed: readonly PlacedName[] = [];
  #light: Light = "day";
  #countries: CountryNames = (code) => code;
  #graticule: CompassLetters | null = null;
  #onAirfield: ((picked: PickedAirfield) => void) | null = null;
  #next = 0;
  #sight: Sight | null = null;

  constructor(globe: Globe) {
    this.#globe = globe;
    this.#names = new NamedThings(keptWorld(), () => this.#take());
    this.#ends = [
      globe.labels.addWriter((projector, width, height) => this.#write(projector, width, height)),
      pointerOf(globe).addLastFinder((at) => this.#find(globe.labels.find(at, REACH_PX))),
    ];
  }

  /** By day or by night; names of countries by their codes; letters of the graticule, null without one. */
  set(light: Light, countries: CountryNames, graticule: CompassLetters | null): void {
    this.#light = light;
    this.#countries = countries;
    this.#graticule = graticule;
    this.#globe.labels.setLight(light);
    this.#globe.repaintLabels();
  }

  onAirfield(listener: ((picked: PickedAirfield) => void) | null): void {
    this.#onAirfield = listener;
  }

  dispose(): void {
    this.#names.dispose();
    for (const end of this.#ends) {
      end();
    }
  }

  #take(): void {
    this.#placed = this.#names.things.map((thing) => ({
      thing,
      position: Cartesian3.fromDegrees(thing.longitude_deg, thing.latitude_deg),
    }));
    this.#globe.repaintLabels();
  }

  #write(projector: Projector, width: number, height: number): ShownText[] {
    this.#look(width, height);
    this.#lift();
    const texts: ShownText[] = [];
    for (const { thing, position } of this.#placed) {
      const at = projector.ground(position);
      if (at !== null) {
        texts.push(textOf(thing, at, this.#light, this.#countries));
      }
    }
    if (this.#graticule !== null && this.#sight !== null) {
      const { centre, sight_m } = this.#sight;
      const pixel_m = this.#pixelAt(sight_m, height);
      for (const { key, text, place } of nameAngles(centre, pixel_m, this.#graticule)) {
        const at = projector.ground(Cartesian3.fromDegrees(place.longitude_deg, place.latitude_deg));
        if (at !== null) {
          texts.push({ ...GRATICULE_TEXT, key, text, at });
        }
      }
    }
    return texts;
  }

  #look(width: number, height: number): void {
    const { camera } = this.#globe.scene;
    const middle = camera.pickEllipsoid(new Cartesian2(width / 2, height * LOOKED_AT));
    const { height: eye_m } = camera.positionCartographic;
    const horizon_m = Math.sqrt(2 * 6_371_000 * Math.max(10, eye_m));
    const place = middle === undefined ? camera.positionCartographic : Cartographic.fromCartesian(middle);
    const sight_m =
      middle === undefined ? Math.max(500, eye_m) : Cartesian3.distance(camera.positionWC, middle);
    const reach_m = Math.min(horizon_m + sight_m, 9_000_000);
    const pixel_m = this.#pixelAt(sight_m, height);
    const zones: NamedZone[] = [];
    let from_m = 0;
    const add = (level: 0 | 1 | 2, to_m: number): void => {
      if (to_m > from_m) {
        zones.push({ level, from_m, to_m });
        from_m = to_m;
      }
    };
    if (levelFor(pixel_m) === 2) {
      add(2, Math.min(NEAR_M, reach_m));
    }
    if (levelFor(pixel_m) >= 1) {
      add(1, Math.min(REGION_M, reach_m));
    }
    add(0, reach_m);
    this.#sight = { centre: positionOf(place), sight_m, zones };
    this.#names.see(this.#sight);
  }

  /** Metres of a pixel at a distance. */
  #pixelAt(distance_m: number, height: number): number {
    const { fovy } = this.#globe.scene.camera.frustum as unknown as { readonly fovy?: number };
    return (2 * distance_m * Math.tan((fovy ?? Math.PI / 3) / 2)) / height;
  }

  /** Put some things onto the terrain, in turn: it is loaded bit by bit. */
  #lift(): void {
    const { globe, terrainProvider } = this.#globe.scene;
    if (terrainProvider instanceof EllipsoidTerrainProvider || this.#placed.length === 0) {
      return;
    }
    for (let count = 0; count < HEIGHTS_A_PICTURE; count += 1) {
      this.#next = (this.#next + 1) % this.#placed.length;
      const one = this.#placed[this.#next];
      if (one !== undefined) {
        const { longitude_deg, latitude_deg } = one.thing;
        const height_m = globe.getHeight(Cartographic.fromDegrees(longitude_deg, latitude_deg));
        one.position = Cartesian3.fromDegrees(longitude_deg, latitude_deg, height_m ?? 0);
      }
    }
  }

  #find(key: string | null) {
    const listener = this.#onAirfield;
    const thing = this.#placed.find((one) => one.thing.key === key)?.thing;
    if (listener === null || thing?.kind !== "airfield") {
      return null;
    }
    const { code, latitude_deg, longitude_deg } = thing.airfield;
    return { cursor: "pointer", click: () => listener({ code, latitude_deg, longitude_deg }), drag: null };
  }
}

function positionOf({ latitude, longitude }: Cartographic): Position {
  return { latitude_deg: CesiumMath.toDegrees(latitude), longitude_deg: CesiumMath.toDegrees(longitude) };
}
