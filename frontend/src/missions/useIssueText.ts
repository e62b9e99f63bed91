import { useCallback } from "react";
import { useTranslation } from "react-i18next";
import { formatFixed } from "../lib/format";
import type { PlanIssue } from "../lib/planCheck";
import { useUnit } from "../readouts/useUnit";
import { COLUMN } from "./planFacts";

/** A plan's fault as a sentence, with numbers in the user's units. */
export function useIssueText(): (issue: PlanIssue) => string {
  const { t } = useTranslation();
  const altitude = useUnit("altitude");
  const speed = useUnit("speed");
  const distance = useUnit("distance");
  return useCallback(
    ({ code, row, field, params }) => {
      const number = (row ?? 0) + 1;
      const written = (name: string): string => {
        const value = params[name] ?? null;
        switch (name === "value" || name === "minimum" || name === "maximum" ? field : name) {
          case "altitude_ft":
          case "ceiling_ft":
          case "below_ft":
            return `${altitude.format(value) ?? t("words.dash")} ${altitude.label}`;
          case "speed_kt":
          case "least_kt":
            return `${speed.format(value) ?? t("words.dash")} ${speed.label}`;
          case "distance_m":
          case "radius_m":
            return `${distance.format(value) ?? t("words.dash")} ${distance.label}`;
          case "climb_deg":
          case "most_deg":
            return formatFixed(value, 1) ?? t("words.dash");
          default:
            return String(value ?? t("words.dash"));
        }
      };
      return t(`planIssue.${code}`, {
        number,
        column: field === null ? "" : t(`plans.${COLUMN[field]}`),
        count: params["count"] ?? 0,
        value: written("value"),
        minimum: written("minimum"),
        maximum: written("maximum"),
        climb: written("climb_deg"),
        most: written("most_deg"),
        distance: written("distance_m"),
        radius: written("radius_m"),
        least: written("least_kt"),
        ceiling: written("ceiling_ft"),
        below: written("below_ft"),
      });
    },
    [t, altitude, speed, distance],
  );
}
