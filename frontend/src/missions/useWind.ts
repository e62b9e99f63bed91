import { useMemo } from "react";
import type { Aircraft } from "../lib/aircraft";
import { type Wind, windOf } from "../lib/wind";
import { useSettings, useTelemetry } from "../store/hooks";
import type { Settings } from "../store/settings";
import type { TelemetryStore } from "../store/telemetry";

export const WIND_CHOICES = { from: "plans.wind.from_deg", speed: "plans.wind.speed_kt" } as const;
/** Slower than this the airspeed says little, and in a turn the heading is not the way. */
const LEAST_AIRSPEED_KT = 20;
const STEEPEST_ROLL_DEG = 8;

/** The wind that was entered; still air where none was. */
export function useEnteredWind(): Wind {
  const choices = useSettings((settings) => settings.choices);
  return useMemo(() => enteredWind(choices) ?? { from_deg: 0, speed_kt: 0 }, [choices]);
}

/** The same out of the choices; null where no wind was entered. */
export function enteredWind(choices: Settings["choices"]): Wind | null {
  return choices[WIND_CHOICES.speed] === undefined
    ? null
    : { from_deg: numberOf(choices[WIND_CHOICES.from]), speed_kt: numberOf(choices[WIND_CHOICES.speed]) };
}

function numberOf(choice: string | undefined): number {
  const value = Number(choice ?? 0);
  return Number.isFinite(value) ? value : 0;
}

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

/** Whether the aircraft tells a wind now. */
export function useHasWind(aircraft: Aircraft): boolean {
  return useTelemetry((telemetry, now_ms) => windNow(telemetry, aircraft, now_ms) !== null);
}
