import {
  captureRadius_m,
  type Leg,
  legsOf,
  WAYPOINT_FIELDS,
  type Waypoint,
  type WaypointField,
} from "./plan";

/** The board's limits. */
export interface PlanLimits {
  readonly count: { readonly minimum: number; readonly maximum: number };
  readonly fields: Readonly<Record<WaypointField, { readonly minimum: number; readonly maximum: number }>>;
}

export type PlanFault =
  | "count"
  | "range"
  | "same_place"
  | "too_steep"
  | "steep"
  | "inside_capture"
  | "far"
  | "slow"
  | "outside_fence"
  | "leaves_fence"
  | "above_ceiling"
  | "meets_ground";

/** A fault of a plan. An `error` prevents its upload, a `warning` does not. */
export interface PlanIssue {
  readonly level: "error" | "warning";
  readonly code: PlanFault;
  /** Index of the waypoint, or of the one at which the leg ends; null for the plan as a whole. */
  readonly row: number | null;
  readonly field: WaypointField | null;
  /** The values in the sentence, in the units of their names. */
  readonly params: Readonly<Record<string, number>>;
}

/** Waypoints nearer than this, metres, coincide: the board's positions are no finer. */
const SAME_PLACE_M = 1;
/** The autopilot never commands more pitch than this, degrees: a steeper leg cannot be flown. */
const STEEPEST_CLIMB_DEG = 15;
const STEEPEST_DESCENT_DEG = 20;
/** The usual aircraft gained 300 ft in the closed loop at about this angle, degrees. */
const STEEP_DEG = 8;
/** A leg this long, metres, is more often a wrong sign or digit than a flight. */
const FAR_M = 50_000;
/** Below this the autopilot holds its integrals, knots. */
const SLOW_KT = 20;

/** All faults of a plan, in the order of its waypoints. */
export function checkPlan(waypoints: readonly Waypoint[], limits: PlanLimits): readonly PlanIssue[] {
  const { minimum, maximum } = limits.count;
  const count =
    waypoints.length < minimum || waypoints.length > maximum
      ? [issue("error", "count", null, null, { count: waypoints.length, minimum, maximum })]
      : [];
  const legs = legsOf(waypoints);
  return [
    ...count,
    ...waypoints.flatMap((waypoint, row) => {
      const leg = legs[row - 1];
      const before = waypoints[row - 1];
      const own = checkWaypoint(waypoint, row, limits);
      // Skip a leg with an invalid position.
      const isPlace = before !== undefined && isOnEarth(waypoint, limits) && isOnEarth(before, limits);
      return leg !== undefined && isPlace ? [...own, ...checkLeg(leg, waypoint, row)] : own;
    }),
  ];
}

function checkWaypoint(waypoint: Waypoint, row: number, limits: PlanLimits): PlanIssue[] {
  const found = WAYPOINT_FIELDS.filter((field) => !inRange(waypoint, field, limits)).map((field) =>
    issue("error", "range", row, field, { value: waypoint[field], ...limits.fields[field] }),
  );
  const { speed_kt } = waypoint;
  if (speed_kt < SLOW_KT && inRange(waypoint, "speed_kt", limits)) {
    found.push(issue("warning", "slow", row, "speed_kt", { speed_kt, least_kt: SLOW_KT }));
  }
  return found;
}

function checkLeg(leg: Leg, to: Waypoint, row: number): PlanIssue[] {
  const { distance_m, climb_deg } = leg;
  if (distance_m < SAME_PLACE_M) {
    return [issue("error", "same_place", row, "latitude_deg", {})];
  }
  const found: PlanIssue[] = [];
  const most_deg = climb_deg > 0 ? STEEPEST_CLIMB_DEG : STEEPEST_DESCENT_DEG;
  if (Math.abs(climb_deg) > most_deg) {
    found.push(issue("error", "too_steep", row, "altitude_ft", { climb_deg, most_deg }));
  } else if (Math.abs(climb_deg) > STEEP_DEG) {
    found.push(issue("warning", "steep", row, "altitude_ft", { climb_deg, most_deg: STEEP_DEG }));
  }
  const radius_m = captureRadius_m(to.speed_kt);
  if (distance_m <= radius_m) {
    found.push(issue("warning", "inside_capture", row, "latitude_deg", { distance_m, radius_m }));
  }
  if (distance_m > FAR_M) {
    found.push(issue("warning", "far", row, "latitude_deg", { distance_m }));
  }
  return found;
}

function inRange(waypoint: Waypoint, field: WaypointField, { fields }: PlanLimits): boolean {
  const { minimum, maximum } = fields[field];
  // Written so that NaN counts as outside.
  return waypoint[field] >= minimum && waypoint[field] <= maximum;
}

function isOnEarth(waypoint: Waypoint, limits: PlanLimits): boolean {
  return inRange(waypoint, "latitude_deg", limits) && inRange(waypoint, "longitude_deg", limits);
}

function issue(
  level: PlanIssue["level"],
  code: PlanFault,
  row: number | null,
  field: WaypointField | null,
  params: PlanIssue["params"],
): PlanIssue {
  return { level, code, row, field, params };
}
