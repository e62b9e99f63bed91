import { formatFlightTime } from "../../lib/moment";
import type { FlightReport, ReportManoeuvre } from "../../protocol/guards.gen";

/** Names of figures: their words and definitions are in the catalogue and in the guide. */
export type FigureName =
  | "duration"
  | "airborne"
  | "autopilot"
  | "distance"
  | "highest"
  | "lowest"
  | "fastest"
  | "climbMost"
  | "sinkMost"
  | "batteryBegin"
  | "batteryEnd"
  | "batteryLowest"
  | "batteryDrop"
  | "frames"
  | "damaged"
  | "gaps"
  | "roundTrip"
  | "size"
  | "rise"
  | "overshoot"
  | "settling"
  | "steady"
  | "modelRise"
  | "modelOvershoot"
  | "damping"
  | "modelOff"
  | "across"
  | "altitudeError"
  | "speedError"
  | "loopError";

export const NOTHING = "—";

/** What is not known is a dash. */
export function shown(value: number | null | undefined, digits: number, unit = ""): string {
  if (value === null || value === undefined || !Number.isFinite(value)) {
    return NOTHING;
  }
  const text = value.toFixed(digits);
  const number = Number(text) === 0 ? text.replace("-", "") : text;
  return unit === "" ? number : `${number} ${unit}`;
}

export function time(value_s: number | null): string {
  return value_s === null ? NOTHING : formatFlightTime(value_s);
}

export const UNIT_WORDS: Readonly<Record<string, string>> = { ft: "ft", deg: "°", kt: "kt", m: "m" };

export function withUnit(value: number | null | undefined, unit: string): string {
  return shown(value, unit === "kt" ? 2 : 1, UNIT_WORDS[unit] ?? unit);
}

type Basics = Pick<FlightReport, "times" | "distances" | "battery" | "link">;
/** Words with numbers in them, of the catalogue. */
export type Say = (
  key: "gapsText" | "damagedText" | "roundTripText",
  values: Record<string, string>,
) => string;
export type Row = readonly [FigureName, (flight: Basics, say: Say) => string];

export const TIMES: readonly Row[] = [
  ["duration", ({ times }) => time(times.duration_s)],
  ["airborne", ({ times }) => time(times.airborne_s)],
  ["autopilot", ({ times }) => time(times.autopilot_s)],
  ["distance", ({ distances }) => shown(distances.distance_nm, 2, "NM")],
  ["highest", ({ distances }) => shown(distances.highest_ft, 0, "ft")],
  ["lowest", ({ distances }) => shown(distances.lowest_ft, 0, "ft")],
  ["fastest", ({ distances }) => shown(distances.fastest_kt, 1, "kt")],
  ["climbMost", ({ distances }) => shown(distances.climb_most_ft_min, 0, "ft/min")],
  ["sinkMost", ({ distances }) => shown(distances.sink_most_ft_min, 0, "ft/min")],
];

export const BATTERY: readonly Row[] = [
  ["batteryBegin", ({ battery }) => shown(battery?.begin_v, 2, "V")],
  ["batteryEnd", ({ battery }) => shown(battery?.end_v, 2, "V")],
  ["batteryLowest", ({ battery }) => shown(battery?.lowest_v, 2, "V")],
  ["batteryDrop", ({ battery }) => shown(battery?.drop_v_per_hour, 2, "V/h")],
];

export const LINK: readonly Row[] = [
  ["frames", ({ link }) => shown(link.frames, 0)],
  [
    "damaged",
    ({ link }, say) =>
      say("damagedText", { count: shown(link.frames_damaged, 0), percent: shown(link.damaged_percent, 3) }),
  ],
  [
    "gaps",
    ({ link }, say) =>
      link.gaps === 0
        ? "0"
        : say("gapsText", {
            count: String(link.gaps),
            total: shown(link.gaps_s, 1),
            longest: shown(link.longest_gap_s, 1),
          }),
  ],
  [
    "roundTrip",
    ({ link: { round_trip_ms: trip } }, say) =>
      trip === null
        ? NOTHING
        : say("roundTripText", {
            median: shown(trip.median, 1),
            p99: shown(trip.p99, 1),
            longest: shown(trip.longest, 1),
          }),
  ],
];

export type ManoeuvreRow = readonly [FigureName, (one: ReportManoeuvre, across: string) => string];

/** A figure and how far it may be off, with a digit more of the latter where it would be nought. */
export function doubted(value: number | null, doubt: number | null, digits: number, unit = ""): string {
  if (value === null || doubt === null) {
    return shown(value, digits, unit);
  }
  return `${shown(value, digits)} ± ${shown(doubt, doubt >= 0.1 ** digits ? digits : digits + 1, unit)}`;
}

/** The figures of an answer to a step. */
export const ANSWER: readonly ManoeuvreRow[] = [
  ["size", ({ size, unit }) => withUnit(size, unit)],
  ["rise", ({ rise_s }) => shown(rise_s, 1, "s")],
  ["overshoot", ({ overshoot_percent }) => shown(overshoot_percent, 1, "%")],
  ["settling", ({ settling_s }) => shown(settling_s, 1, "s")],
  ["steady", ({ steady_error, unit }) => withUnit(steady_error, unit)],
];

/** What a model says of the answer that it explains. */
export const MODEL: readonly ManoeuvreRow[] = [
  [
    "modelRise",
    ({ model }) => (model === null ? NOTHING : doubted(model.rise_s, model.rise_doubt_s, 1, "s")),
  ],
  [
    "modelOvershoot",
    ({ model }) =>
      model === null ? NOTHING : doubted(model.overshoot_percent, model.overshoot_doubt_percent, 1, "%"),
  ],
  ["damping", ({ model }) => (model === null ? NOTHING : doubted(model.damping, model.damping_doubt, 2))],
  ["modelOff", ({ model, unit }) => withUnit(model?.off, unit)],
];

/** The figures of a leg; `across` has the words of both cross-track figures. */
export const LEG: readonly ManoeuvreRow[] = [
  ["duration", ({ leg }) => time(leg?.duration_s ?? null)],
  ["distance", ({ leg }) => shown(leg?.distance_m, 0, "m")],
  ["across", ({ leg }, across) => (leg?.across_rms_m == null ? NOTHING : across)],
  ["altitudeError", ({ leg }) => shown(leg?.altitude_error_ft, 1, "ft")],
  ["speedError", ({ leg }) => shown(leg?.speed_error_kt, 2, "kt")],
];
