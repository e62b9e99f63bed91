import type { Aircraft } from "../../../lib/aircraft";
import type { Position } from "../../../lib/geodesy";
import { METRES_PER_FOOT } from "../../../lib/units";
import type { TelemetryStore } from "../../../store/telemetry";

export type AircraftPlace = Position & { readonly altitude_m: number };

/** The topic with an aircraft's position. */
export const PLACE_TOPIC = { flight: "gps", hil: "simulator" } as const;

/**
 * An aircraft's last known position, altitude in metres above mean sea level. It may be old: check the topic's state
 * too.
 */
export function aircraftPlace(telemetry: TelemetryStore, aircraft: Aircraft): AircraftPlace | null {
  const [latitude_deg, longitude_deg, altitude_m] =
    aircraft === "flight"
      ? [
          telemetry.newestNumber("gps", "latitude_deg"),
          telemetry.newestNumber("gps", "longitude_deg"),
          telemetry.newestNumber("gps", "altitude_m"),
        ]
      : [
          telemetry.newestNumber("simulator", "latitude_deg"),
          telemetry.newestNumber("simulator", "longitude_deg"),
          metres(telemetry.newestNumber("simulator", "altitude_msl_ft")),
        ];
  return latitude_deg === null || longitude_deg === null || altitude_m === null
    ? null
    : { latitude_deg, longitude_deg, altitude_m };
}

function metres(feet: number | null): number | null {
  return feet === null ? null : feet * METRES_PER_FOOT;
}
