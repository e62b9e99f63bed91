import { useCallback } from "react";
import { useTranslation } from "react-i18next";
import type { Waypoint } from "../lib/plan";
import type { AltitudeOrigin, ImportedWaypoint } from "../protocol/guards.gen";
import type { PlanName } from "../protocol/missions";
import { useUnit } from "../readouts/useUnit";
import { usePlans } from "./planDrafts";

/**
 * What the altitude of a waypoint was converted from when its file was read; null for one that was typed, moved or read
 * as an altitude above the sea. Place and altitude must be those that were read: otherwise the figures are not its own.
 */
export function originOf(imported: readonly ImportedWaypoint[], waypoint: Waypoint): AltitudeOrigin | null {
  const found = imported.find(
    ({ latitude_deg, longitude_deg, altitude_ft }) =>
      latitude_deg === waypoint.latitude_deg &&
      longitude_deg === waypoint.longitude_deg &&
      altitude_ft === waypoint.altitude_ft,
  );
  return found?.origin ?? null;
}

/** The same as words, in the user's unit: "328 ft above ground, which is at 812 ft". */
export function useOriginText(plan: PlanName): (waypoint: Waypoint) => string | null {
  const { t } = useTranslation();
  const altitude = useUnit("altitude");
  const imported = usePlans((plans) => plans[plan].imported);
  return useCallback(
    (waypoint) => {
      const origin = originOf(imported, waypoint);
      return origin === null
        ? null
        : t(`plans.origin_${origin.frame}`, {
            height: altitude.format(origin.height_ft),
            reference: altitude.format(origin.reference_ft),
            unit: altitude.label,
          });
    },
    [t, altitude, imported],
  );
}
