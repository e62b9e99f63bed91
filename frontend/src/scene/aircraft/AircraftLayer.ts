import { Cartesian3, Color, ColorBlendMode, Matrix4, Model } from "@cesium/engine";
import type { Aircraft } from "../../lib/aircraft";
import type { FullAttitude } from "../../lib/attitude";
import { AIRCRAFT_COLOURS } from "../colours";
import type { Globe } from "../globe/Globe";
import type { SpaceText } from "../globe/GlobeLabels";
import { FLIGHT_RANK, PLAIN_FONT } from "../lettering";
import { airframeFaces } from "./airframe";
import { gltfAddress } from "./gltf";
import { modelMatrix, type Place, type Pose, poseOf } from "./pose";

/** An aircraft as it is drawn in one picture. */
export interface AircraftPose {
  readonly place: Place;
  /** The time of its position, seconds of the gateway's clock. */
  readonly t_s: number;
  /** Null if unknown: then a mark replaces the airframe. */
  readonly attitude: FullAttitude | null;
  /** If not, it is drawn as a ghost. */
  readonly isLive: boolean;
  /** Its name, with its age if not live. */
  readonly label: string;
}

export type AircraftPoses = Readonly<Record<Aircraft, AircraftPose | null>>;
/** What to draw in a picture; null: not drawn. */
export type AircraftFeed = (now_ms: number) => AircraftPoses;

const GHOST = 0.32;
/** From afar it is drawn larger, to stay visible. */
const LEAST_PX = 112;
/** Between the aircraft and its name, pixels. */
const NAME_AWAY_PX = 22;
const NOT_LIVE = "#ffffff";
/** Smaller movements are ignored: metres, and the sine of an angle. */
const STILL_M = 0.004;
const STILL_TURN = 2e-4;

/** The two aircraft on the globe, each where its feed puts it in this picture. */
export class AircraftLayer {
  readonly #globe: Globe;
  readonly #drawn: Readonly<Record<Aircraft, DrawnAircraft>>;
  readonly #endPictures: () => void;
  #feed: AircraftFeed | null = null;
  #seen: AircraftPoses = { flight: null, hil: null };
  #within: Aircraft | null = null;

  constructor(globe: Globe) {
    this.#globe = globe;
    this.#drawn = {
      flight: new DrawnAircraft(globe, "flight"),
      hil: new DrawnAircraft(globe, "hil"),
    };
    this.#endPictures = globe.onBeforePicture((now_ms) => this.#beforePicture(now_ms));
  }

  /** Set the feed that is asked for each picture; null: nothing is drawn. */
  setFeed(feed: AircraftFeed | null): void {
    this.#feed = feed;
    this.#globe.requestRender();
  }

  /** The camera is in this aircraft: its airframe is not drawn. */
  setWithin(aircraft: Aircraft | null): void {
    this.#within = aircraft;
  }

  /** The aircraft as it is drawn now. */
  seen(aircraft: Aircraft): AircraftPose | null {
    return this.#seen[aircraft];
  }

  dispose(): void {
    this.#endPictures();
    this.#drawn.flight.dispose();
    this.#drawn.hil.dispose();
    this.#globe.labels.show(this, []);
  }

  #beforePicture(now_ms: number): void {
    this.#seen = this.#feed?.(now_ms) ?? { flight: null, hil: null };
    const flightMoved = this.#drawn.flight.show(this.#seen.flight, this.#within === "flight");
    const hilMoved = this.#drawn.hil.show(this.#seen.hil, this.#within === "hil");
    const names = [this.#drawn.flight.name, this.#drawn.hil.name].filter((name) => name !== null);
    this.#globe.labels.show(this, names);
    if (flightMoved || hilMoved) {
      this.#globe.requestRender();
    }
  }
}

class DrawnAircraft {
  readonly #globe: Globe;
  readonly #aircraft: Aircraft;
  readonly #colour: Color;
  #name: Omit<SpaceText, "position"> | null = null;
  #position = Cartesian3.ZERO;
  #model: Model | null = null;
  #isDisposed = false;
  #matrix: readonly number[] = [];
  #shown = "";

  constructor(globe: Globe, aircraft: Aircraft) {
    this.#globe = globe;
    this.#aircraft = aircraft;
    this.#colour = Color.fromCssColorString(AIRCRAFT_COLOURS[aircraft]);
    void this.#load();
  }

  /** Its name beside it; null while it is not drawn. */
  get name(): SpaceText | null {
    return this.#name === null ? null : { ...this.#name, position: this.#position };
  }

  /** Returns whether anything visible has changed. */
  show(seen: AircraftPose | null, isWithin: boolean): boolean {
    const shown = seen === null ? "" : `${seen.label}|${seen.isLive}|${seen.attitude === null}|${isWithin}`;
    const isOther = shown !== this.#shown;
    this.#shown = shown;
    this.#name = seen === null || isWithin ? null : this.#named(seen);
    if (this.#model !== null) {
      this.#model.show = seen?.attitude != null && !isWithin;
    }
    if (seen === null) {
      return isOther;
    }
    const pose = poseOf(seen.place, seen.attitude ?? { yaw_deg: 0, pitch_deg: 0, roll_deg: 0 });
    if (isOther) {
      this.#dress(seen);
    }
    // Called first: it must be moved in any case.
    return this.#place(pose) || isOther;
  }

  #named(seen: AircraftPose): Omit<SpaceText, "position"> {
    return {
      key: `aircraft ${this.#aircraft}`,
      text: seen.attitude === null ? `✕ ${seen.label}` : seen.label,
      font: PLAIN_FONT,
      colour: seen.isLive ? AIRCRAFT_COLOURS[this.#aircraft] : NOT_LIVE,
      rank: FLIGHT_RANK + 50,
      away_px: NAME_AWAY_PX,
      isSought: true,
    };
  }

  #dress(seen: AircraftPose): void {
    if (this.#model !== null) {
      this.#model.color = this.#colour.withAlpha(seen.isLive ? 1 : GHOST);
    }
  }

  dispose(): void {
    this.#isDisposed = true;
    if (this.#model !== null) {
      this.#globe.scene.primitives.remove(this.#model);
    }
  }

  #place(pose: Pose): boolean {
    const matrix = modelMatrix(pose);
    const moved = matrix.some(
      (part, index) => Math.abs(part - (this.#matrix[index] ?? 0)) > (index < 12 ? STILL_TURN : STILL_M),
    );
    if (moved) {
      this.#matrix = matrix;
      this.#position = new Cartesian3(...pose.position);
      if (this.#model !== null) {
        this.#model.modelMatrix = Matrix4.fromArray(matrix);
      }
    }
    return moved;
  }

  async #load(): Promise<void> {
    const model = await Model.fromGltfAsync({
      url: gltfAddress(airframeFaces()),
      show: false,
      minimumPixelSize: LEAST_PX,
      color: this.#colour,
      colorBlendMode: ColorBlendMode.HIGHLIGHT,
      allowPicking: false,
      // Environment lighting for a gloss that it does not have: it costs hundreds of milliseconds of processor time
      // per kilometre.
      environmentMapOptions: { enabled: false },
    });
    if (this.#isDisposed || this.#globe.scene.isDestroyed()) {
      model.destroy();
      return;
    }
    this.#model = this.#globe.scene.primitives.add(model) as Model;
    this.#matrix = [];
    this.#shown = "?";
    // Its resources are ready some pictures later.
    model.readyEvent.addEventListener(() => this.#globe.requestRender());
    this.#globe.requestRender();
  }
}
