import { useCallback } from "react";
import { useTranslation } from "react-i18next";
import { formatFixed } from "../lib/format";
import type { PlanIssue } from "../lib/planCheck";
import { useUnit } from "../readouts/useUnit";
import { COLUMN } from "./planFacts";
import type { FlownIssue } from "./rehearsal";

/** A plan's fault, or what its rehearsal found, as a sentence with numbers in the user's units. */
export function useIssueText(): (issue: PlanIssue | FlownIssue) => string {
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
          case "above_ft":
          case "height_ft":
          case "margin_ft":
          case "off_ft":
          case "flown_ft":
            return `${altitude.format(value) ?? t("words.dash")} ${altitude.label}`;
          case "speed_kt":
          case "least_kt":
            return `${speed.format(value) ?? t("words.dash")} ${speed.label}`;
          case "distance_m":
          case "radius_m":
            return `${distance.format(value) ?? t("words.dash")} ${distance.label}`;
          case "climb_deg":
          case "most_deg":
          case "off_deg":
            return formatFixed(value, 1) ?? t("words.dash");
          case "lasts_min":
          case "takes_min":
            return formatFixed(value, 0) ?? t("words.dash");
          default:
            return String(value ?? t("words.dash"));
        }
      };
      return t(`planIssue.${code}`, {
        number,
        column: field === null ? "" : t(`plans.${COLUMN[field]}`),
        count: params["count"] ?? 0,
        // By their names without the unit, which they are written with.
        ...Object.fromEntries(
          Object.keys(params).map((name) => [name.replace(/_(ft|kt|m|deg|min)$/, ""), written(name)]),
        ),
      });
    },
    [t, altitude, speed, distance],
  );
}
