import { useMemo } from "react";
import type { Aircraft } from "../lib/aircraft";
import type { Wind } from "../lib/wind";
import { windNow } from "../readouts/wind";
import { useSettings, useTelemetry } from "../store/hooks";
import type { Settings } from "../store/settings";

export const WIND_CHOICES = { from: "plans.wind.from_deg", speed: "plans.wind.speed_kt" } as const;

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

/** Whether the aircraft tells a wind now. */
export function useHasWind(aircraft: Aircraft): boolean {
  return useTelemetry((telemetry, now_ms) => windNow(telemetry, aircraft, now_ms) !== null);
}
