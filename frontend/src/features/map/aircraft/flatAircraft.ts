import type { Aircraft } from "../../../lib/aircraft";
import { formatAge } from "../../../lib/format";
import type { FlatAircraft } from "../../../scene/flat/flatThings";
import type { TelemetryStore } from "../../../store/telemetry";
import { TRACK_KINDS } from "../track/trackKinds";
import { showing } from "./aircraftFeed";
import { aircraftPlace, PLACE_TOPIC } from "./aircraftPlace";

const ATTITUDE_TOPIC = { flight: "ahrs", hil: "simulator" } as const;

/** An aircraft seen from above: live, or hollow with its age; null if it is not drawn. */
export function flatAircraft(
  telemetry: TelemetryStore,
  plan: Aircraft,
  name: string,
  now_ms: number,
): FlatAircraft | null {
  const how = showing(telemetry, plan, now_ms);
  const place = aircraftPlace(telemetry, plan);
  if (place === null || how === "notHeard" || how === "noPosition") {
    return null;
  }
  const heading_deg =
    plan === "hil"
      ? telemetry.newestNumber("simulator", "true_heading_deg")
      : telemetry.newestNumber("ahrs", "yaw_deg");
  const topics = [PLACE_TOPIC[plan], ...(heading_deg === null ? [] : [ATTITUDE_TOPIC[plan]])];
  const isLive = topics.every((topic) => telemetry.state(topic, now_ms) === "live");
  const age_s = Math.max(...topics.map((topic) => telemetry.age_s(topic, now_ms) ?? 0));
  return {
    plan,
    place: { latitude_deg: place.latitude_deg, longitude_deg: place.longitude_deg },
    heading_deg,
    colour: TRACK_KINDS[plan].plain,
    label: isLive ? name : `${name} · ${formatAge(age_s)}`,
    isLive,
  };
}
