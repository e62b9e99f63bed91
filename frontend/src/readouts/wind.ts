import type { Aircraft } from "../lib/aircraft";
import { type Wind, windOf } from "../lib/wind";
import type { TelemetryStore } from "../store/telemetry";

/** Slower than this the airspeed says little, and in a turn the heading is not the way. */
const LEAST_AIRSPEED_KT = 20;
const STEEPEST_ROLL_DEG = 8;

/**
 * The wind that the aircraft's live values imply: how it flies through the air and how over the ground. Null unless all
 * of them are live, it flies, and it does not turn. The simulator sends no ground speed.
 */
export function windNow(telemetry: TelemetryStore, aircraft: Aircraft, now_ms: number): Wind | null {
  if (aircraft === "hil") {
    return null;
  }
  const heading_deg = telemetry.liveNumber("ahrs", "yaw_deg", now_ms);
  const roll_deg = telemetry.liveNumber("ahrs", "roll_deg", now_ms);
  const airspeed_kt = telemetry.liveNumber("analog", "calibrated_airspeed_kt", now_ms);
  const track_deg = telemetry.liveNumber("gps", "heading_deg", now_ms);
  const ground_kt = telemetry.liveNumber("gps", "speed_kt", now_ms);
  const isSteady =
    airspeed_kt !== null &&
    airspeed_kt >= LEAST_AIRSPEED_KT &&
    roll_deg !== null &&
    Math.abs(roll_deg) <= STEEPEST_ROLL_DEG;
  return isSteady && heading_deg !== null && track_deg !== null && ground_kt !== null
    ? windOf(heading_deg, airspeed_kt, track_deg, ground_kt)
    : null;
}
