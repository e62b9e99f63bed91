import { legsOf, type Waypoint } from "./plan";
import { convertUnit, DEGREES_PER_RADIAN, wrap360 } from "./units";

/** The wind as pilots say it: whence it blows, true, and how fast. */
export interface Wind {
  readonly from_deg: number;
  readonly speed_kt: number;
}

/** Ground speed along a course, flown at an airspeed; null where the wind is too strong to hold the course. */
export function groundSpeed_kt(course_deg: number, airspeed_kt: number, wind: Wind): number | null {
  const angle = (wind.from_deg - course_deg) / DEGREES_PER_RADIAN;
  const across = wind.speed_kt * Math.sin(angle);
  if (Math.abs(across) >= airspeed_kt) {
    return null;
  }
  const along = Math.sqrt(airspeed_kt ** 2 - across ** 2) - wind.speed_kt * Math.cos(angle);
  return along > 0 ? along : null;
}

/**
 * Seconds for each leg in this wind, with the airspeed of the waypoint at its end (taken as true airspeed); null where
 * it cannot be flown.
 */
export function legTimes_s(waypoints: readonly Waypoint[], wind: Wind): readonly (number | null)[] {
  return legsOf(waypoints).map(({ distance_m, bearing_deg }, index) => {
    const speed_kt = waypoints[index + 1]?.speed_kt ?? 0;
    const ground_kt = groundSpeed_kt(bearing_deg ?? 0, speed_kt, wind);
    return ground_kt === null ? null : distance_m / convertUnit(ground_kt, "kt", "mPerS");
  });
}

/**
 * The wind that explains the difference between flying through the air and over the ground. Heading and track true.
 */
export function windOf(
  heading_deg: number,
  airspeed_kt: number,
  track_deg: number,
  ground_speed_kt: number,
): Wind {
  const [heading, track] = [heading_deg / DEGREES_PER_RADIAN, track_deg / DEGREES_PER_RADIAN];
  const north = ground_speed_kt * Math.cos(track) - airspeed_kt * Math.cos(heading);
  const east = ground_speed_kt * Math.sin(track) - airspeed_kt * Math.sin(heading);
  return {
    from_deg: wrap360(Math.atan2(-east, -north) * DEGREES_PER_RADIAN),
    speed_kt: Math.hypot(north, east),
  };
}
