import type { Position } from "../lib/geodesy";
import { METRES_PER_FOOT } from "../lib/units";
import type { Wind } from "../lib/wind";
import type { Answer } from "../protocol/answers";
import type { HeightSet, MissionRehearsal, RehearsalFinding } from "../protocol/guards.gen";
import type { PlanName } from "../protocol/missions";
import { windNow } from "../readouts/wind";
import type { Settings } from "../store/settings";
import type { TelemetryStore } from "../store/telemetry";
import { enteredWind } from "./useWind";

/** How long the battery lasts from now on, minutes, as it was entered. */
export const ENDURANCE_CHOICE = "plans.endurance_min";

/** Where the aircraft is, as the gateway takes it: feet above the sea, true track, indicated airspeed. */
interface RehearsalStart extends Position {
  readonly altitude_ft: number;
  readonly track_deg: number;
  readonly speed_kt: number;
}

/** What a plan is flown in: the aircraft's place, null if it is not known now, and the wind with where it comes from. */
export interface FlightConditions {
  readonly start: RehearsalStart | null;
  readonly wind: Wind;
  readonly windSource: "entered" | "aircraft" | "none";
  readonly endurance_min: number | null;
}

/** A rehearsal that has ended, or why there was none. */
export interface RehearsalEnd {
  readonly conditions: FlightConditions;
  readonly answer: Answer<MissionRehearsal>;
}

/** A finding as an issue of its plan: what happens on the leg to waypoint `row`. */
export interface FlownIssue {
  readonly code: `flown_${RehearsalFinding["code"]}`;
  readonly row: number;
  readonly field: null;
  readonly params: Readonly<Record<string, number>>;
}

/** The conditions of now: live values only, and the wind that was entered before the one that the aircraft tells. */
export function conditionsNow(
  telemetry: TelemetryStore,
  { choices }: Settings,
  plan: PlanName,
  now_ms: number,
): FlightConditions {
  const entered = enteredWind(choices);
  const told = entered === null ? windNow(telemetry, plan, now_ms) : null;
  const endurance_min = Number(choices[ENDURANCE_CHOICE] ?? 0);
  return {
    start: startNow(telemetry, plan, now_ms),
    wind: entered ?? told ?? { from_deg: 0, speed_kt: 0 },
    windSource: entered !== null ? "entered" : told !== null ? "aircraft" : "none",
    endurance_min: endurance_min > 0 ? endurance_min : null,
  };
}

export function flownIssues({ answer }: RehearsalEnd): readonly FlownIssue[] {
  return answer.ok
    ? answer.value.findings.map(({ code, row, params }) => ({
        code: `flown_${code}`,
        row,
        field: null,
        params,
      }))
    : [];
}

/** The sets of terrain by which the ground was judged, and of which nobody has said what their heights count from. */
export function doubtfulHeights({ answer }: RehearsalEnd): readonly HeightSet[] {
  return answer.ok ? answer.value.heights.filter(({ datum }) => datum === null) : [];
}

function startNow(telemetry: TelemetryStore, plan: PlanName, now_ms: number): RehearsalStart | null {
  const values =
    plan === "hil"
      ? {
          latitude_deg: telemetry.liveNumber("simulator", "latitude_deg", now_ms),
          longitude_deg: telemetry.liveNumber("simulator", "longitude_deg", now_ms),
          altitude_ft: telemetry.liveNumber("simulator", "altitude_msl_ft", now_ms),
          track_deg: telemetry.liveNumber("simulator", "horizontal_path_deg", now_ms),
          speed_kt: telemetry.liveNumber("simulator", "indicated_airspeed_kt", now_ms),
        }
      : hasFix(telemetry, now_ms)
        ? {
            latitude_deg: telemetry.liveNumber("gps", "latitude_deg", now_ms),
            longitude_deg: telemetry.liveNumber("gps", "longitude_deg", now_ms),
            altitude_ft: feet(telemetry.liveNumber("gps", "altitude_m", now_ms)),
            track_deg: telemetry.liveNumber("gps", "heading_deg", now_ms),
            speed_kt:
              telemetry.liveNumber("analog", "calibrated_airspeed_kt", now_ms) ??
              telemetry.liveNumber("gps", "speed_kt", now_ms),
          }
        : null;
  if (values === null) {
    return null;
  }
  const { latitude_deg, longitude_deg, altitude_ft, track_deg, speed_kt } = values;
  return latitude_deg === null || longitude_deg === null || altitude_ft === null
    ? null
    : {
        latitude_deg,
        longitude_deg,
        altitude_ft,
        track_deg: track_deg ?? 0,
        speed_kt: Math.max(0, speed_kt ?? 0),
      };
}

function hasFix(telemetry: TelemetryStore, now_ms: number): boolean {
  return (
    telemetry.liveNumber("gps", "fix", now_ms) !== 0 && telemetry.liveFlag("gps", "valid", now_ms) !== false
  );
}

function feet(metres: number | null): number | null {
  return metres === null ? null : metres / METRES_PER_FOOT;
}
