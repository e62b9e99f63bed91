import type { ParseKeys } from "i18next";
import type { Aircraft } from "../lib/aircraft";
import { convertUnit } from "../lib/units";
import type { NumberField, TopicName } from "../protocol/topics";
import { type Quantity, unitOfField, usualUnit } from "../store/chosenUnits";
import type { TelemetryStore } from "../store/telemetry";
import { boardBearing_deg, type flownPlan, type ReadLive } from "./LiveHeading";
import type { ReadoutRow } from "./LiveReadout";
import { ANGLE, HEADING } from "./notations";

/** A field of a topic, for an instrument and for the readout under it. */
export interface Source {
  readonly topic: TopicName;
  readonly row: ReadoutRow;
  /** In the unit in which the instrument is painted: degrees, knots, feet, feet per minute. */
  readonly read: ReadLive;
}

/** A source with the word on the instrument's face. */
export interface PointerSource extends Source {
  readonly caption: ParseKeys;
}

/** Where the six instruments of one aircraft get their values. */
export interface SixSources {
  /** The airspeed that the board flies by: of its GPS, or of its tube. */
  readonly airspeed: (isGps: boolean) => PointerSource;
  readonly attitude: "ahrs" | "simulator";
  readonly altimeterBaro: PointerSource;
  readonly altimeterGps: PointerSource;
  readonly heading: Source;
  /** The bearing that the heading's bug shows, and the readout of the plan from which it comes. */
  readonly bearing_deg: ReadLive;
  readonly bug: (flown: ReturnType<typeof flownPlan>) => Source;
  readonly verticalSpeed: PointerSource;
}

/** Pitch and roll under the artificial horizon. */
export const ATTITUDE_ROWS: readonly ReadoutRow<"pitch_deg" | "roll_deg">[] = [
  { field: "pitch_deg", group: "hil.ahrs", label: "attitude.pitch", as: ANGLE },
  { field: "roll_deg", label: "attitude.roll", as: ANGLE },
];

const GPS_SPEED = pointer(
  "gps",
  { field: "speed_kt", group: "flight.gps", label: "gps.speed", as: "speed" },
  "six.captionGps",
);
const PITOT_SPEED = pointer(
  "analog",
  { field: "calibrated_airspeed_kt", group: "flight.analog", label: "analog.speed", as: "speed" },
  "six.captionPitot",
);
const INDICATED_SPEED = pointer(
  "simulator",
  { field: "indicated_airspeed_kt", group: "hil.ads", label: "hil.airspeed", as: "speed", unit: "unit.kias" },
  "six.captionIndicated",
);
const BUG = {
  fms_plan: angle("fms_plan", { field: "bearing_deg", group: "flight.fms", label: "fms.bearing" }),
  fms_hil_plan: angle("fms_hil_plan", { field: "bearing_deg", group: "six.fmsHil", label: "fms.bearing" }),
};

export const SIX: Readonly<Record<Aircraft, SixSources>> = {
  flight: {
    airspeed: (isGps) => (isGps ? GPS_SPEED : PITOT_SPEED),
    attitude: "ahrs",
    altimeterBaro: pointer(
      "analog",
      { field: "altitude_m", group: "flight.analog", label: "analog.altitude", as: "altitude" },
      "six.captionBaro",
    ),
    altimeterGps: pointer(
      "gps",
      { field: "altitude_m", group: "flight.gps", label: "gps.altitude", as: "altitude" },
      "six.captionGps",
    ),
    heading: angle("ahrs", { field: "yaw_deg", group: "hil.ahrs", label: "attitude.heading" }),
    bearing_deg: boardBearing_deg,
    bug: (flown) => BUG[flown],
    verticalSpeed: pointer(
      "analog",
      { field: "vvi_ft_min", group: "flight.analog", label: "hil.vvi", as: "verticalSpeed" },
      "six.captionVerticalSpeed",
    ),
  },
  hil: {
    airspeed: () => INDICATED_SPEED,
    attitude: "simulator",
    altimeterBaro: pointer(
      "simulator",
      { field: "altitude_indicated_ft", group: "hil.ads", label: "hil.altitude", as: "altitude" },
      "six.captionBaro",
    ),
    altimeterGps: pointer(
      "simulator",
      { field: "altitude_msl_ft", group: "hil.gps", label: "gps.altitude", as: "altitude" },
      "six.captionGps",
    ),
    heading: angle("simulator", { field: "true_heading_deg", group: "hil.ahrs", label: "attitude.heading" }),
    bearing_deg: BUG.fms_hil_plan.read,
    bug: () => BUG.fms_hil_plan,
    verticalSpeed: pointer(
      "simulator",
      { field: "vvi_ft_min", group: "hil.loads", label: "hil.vvi", as: "verticalSpeed" },
      "six.captionVerticalSpeed",
    ),
  },
};

type Row<T extends TopicName> = ReadoutRow<NumberField<T>>;

function pointer<T extends TopicName>(
  topic: T,
  row: Row<T> & { readonly as: Quantity },
  caption: ParseKeys,
): PointerSource {
  const [sent, painted] = [unitOfField(row.field), usualUnit(row.as)];
  const read: ReadLive = (telemetry, now_ms) => {
    const value =
      topic === "gps" && !hasFix(telemetry, now_ms) ? null : telemetry.liveNumber(topic, row.field, now_ms);
    return value === null ? null : convertUnit(value, sent, painted);
  };
  return { topic, row, caption, read };
}

function angle<T extends TopicName>(topic: T, row: Omit<Row<T>, "as">): Source {
  return {
    topic,
    row: { ...row, as: HEADING, chars: 5 },
    read: (telemetry, now_ms) => telemetry.liveNumber(topic, row.field, now_ms),
  };
}

/** Without a fix the receiver goes on sending its last position and speed. */
function hasFix(telemetry: TelemetryStore, now_ms: number): boolean {
  return (
    telemetry.liveNumber("gps", "fix", now_ms) !== 0 && telemetry.liveFlag("gps", "valid", now_ms) !== false
  );
}

/**
 * Whether the board takes its airspeed from the GPS: it says so once a second. If it does not, it has only the tube.
 */
export function isGpsSpeed(telemetry: TelemetryStore, now_ms: number): boolean {
  return telemetry.liveNumber("board_status", "airspeed_source", now_ms) === GPS;
}

const GPS = 0;
