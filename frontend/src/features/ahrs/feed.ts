import type { FullAttitude } from "../../lib/attitude";
import type { AttitudeScene } from "../../scene/attitude/AttitudeScene";
import type { CameraView } from "../../scene/attitude/OrbitRig";
import type { TelemetryStore } from "../../store/telemetry";
import type { AttitudeSource } from "./alignment";
import { liveVectors } from "./source";

type Angle = keyof FullAttitude;
const ANGLES: readonly Angle[] = ["yaw_deg", "pitch_deg", "roll_deg"];
const ATTRIBUTES: Readonly<Record<Angle, string>> = {
  yaw_deg: "yawDeg",
  pitch_deg: "pitchDeg",
  roll_deg: "rollDeg",
};

/** What the feed needs of the scene. */
export type FeedScene = Pick<
  AttitudeScene,
  "sample" | "clear" | "setLive" | "setVectors" | "look" | "shownAttitude"
>;

/** The attitude with all its angles; null while it is not live, or when one of them is missing. */
export function liveAttitude(
  telemetry: TelemetryStore,
  source: AttitudeSource,
  now_ms: number,
): FullAttitude | null {
  const [yaw_deg, pitch_deg, roll_deg] = ANGLES.map((angle) => telemetry.liveNumber(source, angle, now_ms));
  return yaw_deg == null || pitch_deg == null || roll_deg == null ? null : { yaw_deg, pitch_deg, roll_deg };
}

export function isWhole(telemetry: TelemetryStore, source: AttitudeSource, now_ms: number): boolean {
  return liveAttitude(telemetry, source, now_ms) !== null;
}

/** Hands each sample to the scene once, and requests a new picture only when something differs. */
export class AttitudeFeed {
  readonly #scene: FeedScene;
  readonly #changed: () => void;
  #source: AttitudeSource | null = null;
  #at_s: number | null = null;
  #isLive: boolean | null = null;
  #vectors = "";
  #told = "";

  constructor(scene: FeedScene, changed: () => void) {
    this.#scene = scene;
    this.#changed = changed;
  }

  /** `view`: where to put the camera relative to the first sample; null leaves it. */
  feed(telemetry: TelemetryStore, source: AttitudeSource, view: CameraView | null, now_ms: number): void {
    if (source !== this.#source) {
      this.#source = source;
      this.#at_s = null;
      this.#scene.clear();
      this.#changed();
    }
    const attitude = liveAttitude(telemetry, source, now_ms);
    const at_s = telemetry.newestAt_s(source);
    if (attitude !== null && at_s !== this.#at_s) {
      const isFirst = this.#at_s === null;
      this.#at_s = at_s;
      this.#scene.sample(attitude, now_ms);
      if (isFirst && view !== null) {
        this.#scene.look(view);
      }
      this.#changed();
    }
    this.#feedState(attitude !== null);
    this.#feedVectors(telemetry, attitude !== null, now_ms);
  }

  /**
   * Writes what the model shows after `drawn` pictures to the dataset, for tests and screen readers. It is the drawn
   * attitude, not the received one.
   */
  tell(dataset: DOMStringMap, drawn: number): void {
    const told = `${drawn} ${this.#isLive}`;
    if (told === this.#told) {
      return;
    }
    this.#told = told;
    dataset["pictures"] = `${drawn}`;
    const shown = this.#scene.shownAttitude;
    dataset["state"] = this.#isLive === true ? "live" : shown === null ? "none" : "stale";
    for (const angle of ANGLES) {
      if (this.#isLive === true && shown !== null) {
        dataset[ATTRIBUTES[angle]] = shown[angle].toFixed(1);
      } else {
        delete dataset[ATTRIBUTES[angle]];
      }
    }
  }

  #feedState(isLive: boolean): void {
    if (isLive !== this.#isLive) {
      this.#isLive = isLive;
      this.#scene.setLive(isLive);
      this.#changed();
    }
  }

  #feedVectors(telemetry: TelemetryStore, isLive: boolean, now_ms: number): void {
    const { acceleration_m_s2, field } = isLive
      ? liveVectors(telemetry, now_ms)
      : { acceleration_m_s2: null, field: null };
    const vectors = `${acceleration_m_s2?.join()} ${field?.join()}`;
    if (vectors !== this.#vectors) {
      this.#vectors = vectors;
      this.#scene.setVectors(acceleration_m_s2, field);
      this.#changed();
    }
  }
}
