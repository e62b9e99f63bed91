import { useTranslation } from "react-i18next";
import type { Aircraft } from "../../lib/aircraft";
import { PLAN } from "../../missions/planFacts";
import { ROUTES } from "../../protocol/messages.gen";
import { useFlownAircraft } from "../../readouts/flownAircraft";
import { useUnit } from "../../readouts/useUnit";
import { useConnection, useIsPast, useTelemetry } from "../../store/hooks";

const PRESENT = { flight: "fly.what.flight", hil: "fly.what.hil" } as const;
const PAST = { flight: "fly.past.flight", hil: "fly.past.hil" } as const;

/** One sentence: what flies, by whom, and where to. It says nothing as present that is not live. */
export function FlightSentence() {
  const { t } = useTranslation();
  const aircraft = useFlownAircraft();
  const isPast = useIsPast();
  const what = t((isPast ? PAST : PRESENT)[aircraft]);
  const how = useHow(aircraft);
  const route = useRoute(aircraft);
  const where = useWhere(aircraft);
  return (
    <p className="fly-sentence">
      <strong>{route === null ? what : t("fly.named", { what, route })}</strong>
      {[how, where].filter((part) => part !== null).map((part) => `, ${part}`)}
    </p>
  );
}

/** The name of the board's own route, as the board reports it; null if it flies another plan or does not say. */
function useRoute(aircraft: Aircraft): string | null {
  const { t } = useTranslation();
  const number = useTelemetry((telemetry, now_ms) =>
    aircraft === "hil" ? telemetry.liveNumber("board_status", "hil_plan_name", now_ms) : null,
  );
  const route = ROUTES.find(({ planName }) => planName === number);
  return route === undefined ? null : t("fly.route", { name: route.title });
}

/** Whether it is heard, and who flies it; null if the board does not say. */
function useHow(aircraft: Aircraft): string | null {
  const { t } = useTranslation();
  const isOpen = useConnection(({ phase }) => phase === "open");
  const state = useTelemetry((telemetry, now_ms) =>
    telemetry.state(aircraft === "hil" ? "simulator" : "ahrs", now_ms),
  );
  const isAutomatic = useTelemetry((telemetry, now_ms) =>
    telemetry.liveFlag("heartbeat", PLAN[aircraft].autopilot, now_ms),
  );
  if (!isOpen) {
    return t("fly.noStation");
  }
  if (state !== "live") {
    return t(state === "none" ? "fly.notHeard" : "fly.silent");
  }
  return isAutomatic === null ? null : t(isAutomatic ? "fly.byAutopilot" : "fly.byHand");
}

/** The waypoint that the board reports to fly to, and how far it is; null if it does not say. */
function useWhere(aircraft: Aircraft): string | null {
  const { t } = useTranslation();
  const distance = useUnit("distance");
  const { topic } = PLAN[aircraft];
  const waypoint = useTelemetry((telemetry, now_ms) => telemetry.liveNumber(topic, "waypoint", now_ms));
  const away = useTelemetry((telemetry, now_ms) =>
    distance.format(telemetry.liveNumber(topic, "distance_m", now_ms)),
  );
  if (waypoint === null) {
    return null;
  }
  return away === null
    ? t("fly.to", { number: waypoint + 1 })
    : t("fly.toAway", { number: waypoint + 1, distance: `${away} ${distance.label}` });
}
