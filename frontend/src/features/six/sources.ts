import { feetFromMetres } from "../../lib/units";
import type { ReadLive } from "../../readouts/LiveHeading";
import type { TelemetryStore } from "../../store/telemetry";

/** A number of the receiver while it has a fix: without one it goes on sending what it last knew. */
function fixed(telemetry: TelemetryStore, field: "speed_kt" | "altitude_m", now_ms: number): number | null {
  const hasFix =
    telemetry.liveNumber("gps", "fix", now_ms) !== 0 && telemetry.liveFlag("gps", "valid", now_ms) !== false;
  return hasFix ? telemetry.liveNumber("gps", field, now_ms) : null;
}

/** What the six instruments of the board show, in the units in which they are painted. */
export const pitotAirspeed_kt: ReadLive = (telemetry, now_ms) =>
  telemetry.liveNumber("analog", "calibrated_airspeed_kt", now_ms);

export const gpsSpeed_kt: ReadLive = (telemetry, now_ms) => fixed(telemetry, "speed_kt", now_ms);

export const baroAltitude_ft: ReadLive = (telemetry, now_ms) => {
  const altitude_m = telemetry.liveNumber("analog", "altitude_m", now_ms);
  return altitude_m === null ? null : feetFromMetres(altitude_m);
};

export const gpsAltitude_ft: ReadLive = (telemetry, now_ms) => {
  const altitude_m = fixed(telemetry, "altitude_m", now_ms);
  return altitude_m === null ? null : feetFromMetres(altitude_m);
};

export const boardVerticalSpeed_ft_min: ReadLive = (telemetry, now_ms) =>
  telemetry.liveNumber("analog", "vvi_ft_min", now_ms);

/** And those of the simulator. */
export const simulatorAirspeed_kt: ReadLive = (telemetry, now_ms) =>
  telemetry.liveNumber("simulator", "indicated_airspeed_kt", now_ms);

export const simulatorBaroAltitude_ft: ReadLive = (telemetry, now_ms) =>
  telemetry.liveNumber("simulator", "altitude_indicated_ft", now_ms);

export const simulatorGpsAltitude_ft: ReadLive = (telemetry, now_ms) =>
  telemetry.liveNumber("simulator", "altitude_msl_ft", now_ms);

export const simulatorHeading_deg: ReadLive = (telemetry, now_ms) =>
  telemetry.liveNumber("simulator", "true_heading_deg", now_ms);

export const hilBearing_deg: ReadLive = (telemetry, now_ms) =>
  telemetry.liveNumber("fms_hil_plan", "bearing_deg", now_ms);

export const simulatorVerticalSpeed_ft_min: ReadLive = (telemetry, now_ms) =>
  telemetry.liveNumber("simulator", "vvi_ft_min", now_ms);

/**
 * Whether the board takes its airspeed from the GPS; it says so once a second. A board that does not say has only the
 * tube.
 */
export function isGpsSpeed(telemetry: TelemetryStore, now_ms: number): boolean {
  return telemetry.liveNumber("board_status", "airspeed_source", now_ms) === GPS;
}

const GPS = 0;
