import type { Aircraft } from "../../../lib/aircraft";
import { attitudeOf, between, type FullAttitude, type Quaternion, quaternionOf } from "../../../lib/attitude";
import { formatAge } from "../../../lib/format";
import type { NumberField, TopicName } from "../../../protocol/topics";
import type { AircraftPose, AircraftPoses } from "../../../scene/aircraft/AircraftLayer";
import type { Place } from "../../../scene/aircraft/pose";
import type { TelemetryStore } from "../../../store/telemetry";
import { aircraftPlace, PLACE_TOPIC } from "./aircraftPlace";
import { Playout } from "./playout";

/** The topic with an aircraft's attitude, and its heading field. */
const ATTITUDE = {
  flight: { topic: "ahrs", yaw: "yaw_deg" },
  hil: { topic: "simulator", yaw: "true_heading_deg" },
} as const;

/** Whether an aircraft is drawn live or stale, or why it is not drawn. */
export type AircraftState = "live" | "stale" | "noPosition" | "notHeard" | "noAttitude";

export function showing(telemetry: TelemetryStore, aircraft: Aircraft, now_ms: number): AircraftState {
  const position = telemetry.state(PLACE_TOPIC[aircraft], now_ms);
  if (position === "none") {
    return "notHeard";
  }
  if (placeOf(telemetry, aircraft) === null) {
    return "noPosition";
  }
  if (attitudeNow(telemetry, aircraft) === null) {
    return "noAttitude";
  }
  const isLive = position === "live" && telemetry.state(ATTITUDE[aircraft].topic, now_ms) === "live";
  return isLive ? "live" : "stale";
}

/** An aircraft's last known position; null if its receiver marks it invalid. */
function placeOf(telemetry: TelemetryStore, aircraft: Aircraft): Place | null {
  return aircraft === "flight" && telemetry.newestFlag("gps", "valid") === false
    ? null
    : aircraftPlace(telemetry, aircraft);
}

function attitudeNow(telemetry: TelemetryStore, aircraft: Aircraft): FullAttitude | null {
  const [yaw_deg, pitch_deg, roll_deg] =
    aircraft === "flight"
      ? numbers(telemetry, "ahrs", ["yaw_deg", "pitch_deg", "roll_deg"])
      : numbers(telemetry, "simulator", ["true_heading_deg", "pitch_deg", "roll_deg"]);
  return yaw_deg == null || pitch_deg == null || roll_deg == null ? null : { yaw_deg, pitch_deg, roll_deg };
}

function numbers<T extends TopicName>(
  telemetry: TelemetryStore,
  topic: T,
  fields: readonly NumberField<T>[],
): (number | null)[] {
  return fields.map((field) => telemetry.newestNumber(topic, field));
}

/** Both aircraft as they are drawn: interpolated between samples, one sample behind. */
export class AircraftMotion {
  readonly #places: Readonly<Record<Aircraft, Playout<Place>>> = {
    flight: new Playout(placeBetween),
    hil: new Playout(placeBetween),
  };
  readonly #turns: Readonly<Record<Aircraft, Playout<Quaternion>>> = {
    flight: new Playout(between),
    hil: new Playout(between),
  };
  #jumps = 0;

  /** Take new samples: called often enough to miss none. */
  take(telemetry: TelemetryStore, now_ms: number): void {
    if (telemetry.jumps !== this.#jumps) {
      this.#jumps = telemetry.jumps;
      for (const playout of [...Object.values(this.#places), ...Object.values(this.#turns)]) {
        playout.clear();
      }
    }
    for (const aircraft of ["flight", "hil"] as const) {
      push(this.#places[aircraft], telemetry, PLACE_TOPIC[aircraft], placeOf(telemetry, aircraft), now_ms);
      const attitude = attitudeNow(telemetry, aircraft);
      const turn = attitude === null ? null : quaternionOf(attitude);
      push(this.#turns[aircraft], telemetry, ATTITUDE[aircraft].topic, turn, now_ms);
    }
  }

  seen(telemetry: TelemetryStore, names: Readonly<Record<Aircraft, string>>, now_ms: number): AircraftPoses {
    return {
      flight: this.#seen(telemetry, "flight", names.flight, now_ms),
      hil: this.#seen(telemetry, "hil", names.hil, now_ms),
    };
  }

  #seen(telemetry: TelemetryStore, aircraft: Aircraft, name: string, now_ms: number): AircraftPose | null {
    const how = showing(telemetry, aircraft, now_ms);
    const place = at(this.#places[aircraft], telemetry, PLACE_TOPIC[aircraft], now_ms);
    if (place === null || how === "notHeard" || how === "noPosition") {
      return null;
    }
    const turn = at(this.#turns[aircraft], telemetry, ATTITUDE[aircraft].topic, now_ms);
    const ages = [PLACE_TOPIC[aircraft], ATTITUDE[aircraft].topic].map(
      (topic) => telemetry.age_s(topic, now_ms) ?? 0,
    );
    return {
      place: place.value,
      t_s: place.t_s,
      attitude: turn === null || how === "noAttitude" ? null : attitudeOf(turn.value),
      isLive: how === "live",
      label: how === "live" ? name : `${name} · ${formatAge(Math.max(...ages))}`,
    };
  }
}

function push<T>(
  playout: Playout<T>,
  telemetry: TelemetryStore,
  topic: TopicName,
  value: T | null,
  now_ms: number,
): void {
  const sampled_s = telemetry.newestAt_s(topic);
  const age_s = telemetry.age_s(topic, now_ms);
  if (value === null) {
    playout.clear();
  } else if (sampled_s !== null && age_s !== null) {
    playout.push(sampled_s, value, sampled_s + age_s);
  }
}

function at<T>(playout: Playout<T>, telemetry: TelemetryStore, topic: TopicName, now_ms: number) {
  const sampled_s = telemetry.newestAt_s(topic);
  const age_s = telemetry.age_s(topic, now_ms);
  return sampled_s === null || age_s === null ? null : playout.at(sampled_s + age_s);
}

function placeBetween(from: Place, to: Place, share: number): Place {
  const mix = (one: number, other: number): number => one + share * (other - one);
  return {
    latitude_deg: mix(from.latitude_deg, to.latitude_deg),
    longitude_deg: mix(from.longitude_deg, to.longitude_deg),
    altitude_m: mix(from.altitude_m, to.altitude_m),
  };
}
