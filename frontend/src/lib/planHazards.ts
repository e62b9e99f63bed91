import { crosses, isInside } from "./fenceBorder";
import type { Position } from "./geodesy";
import type { Waypoint } from "./plan";
import type { PlanIssue } from "./planCheck";
import type { Clearance } from "./planProfile";

/** What a plan must stay within: a border of three corners or more, or none; a ceiling, feet above the sea, or none. */
export interface Fence {
  readonly corners: readonly Position[];
  readonly ceiling_ft: number | null;
}

/**
 * Where a plan leaves the fence by its geometry alone: waypoints outside or above the ceiling, and legs between two
 * waypoints inside that cross the border.
 */
export function fenceHazards(
  waypoints: readonly Waypoint[],
  { corners, ceiling_ft }: Fence,
): readonly PlanIssue[] {
  const hasBorder = corners.length > 2;
  return waypoints.flatMap((waypoint, row) => {
    const found: PlanIssue[] = [];
    const before = waypoints[row - 1];
    const isWithin = (place: Position): boolean => !hasBorder || isInside(corners, place);
    if (!isWithin(waypoint)) {
      found.push(hazard("outside_fence", row, "latitude_deg", {}));
    } else if (before !== undefined && hasBorder && isWithin(before) && crosses(corners, before, waypoint)) {
      found.push(hazard("leaves_fence", row, "latitude_deg", {}));
    }
    if (ceiling_ft !== null && waypoint.altitude_ft > ceiling_ft) {
      found.push(hazard("above_ceiling", row, "altitude_ft", { ceiling_ft }));
    }
    return found;
  });
}

/** Legs that meet the ground where the station knows it, by the row of their end. */
export function groundHazards(clearance: Clearance | null): readonly PlanIssue[] {
  return (clearance?.low ?? [])
    .filter(({ clearance_ft }) => clearance_ft <= 0)
    .map(({ row, clearance_ft }) => hazard("meets_ground", row, "altitude_ft", { below_ft: -clearance_ft }));
}

function hazard(
  code: PlanIssue["code"],
  row: number,
  field: PlanIssue["field"],
  params: PlanIssue["params"],
): PlanIssue {
  return { level: "warning", code, row, field, params };
}
