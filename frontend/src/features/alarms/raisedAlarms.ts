import type { Alarm } from "../../protocol/contract";
import type { AircraftAround } from "../../protocol/guards.gen";
import type { TopicName } from "../../protocol/topics";
import type { Connection } from "../../store/connection";
import { type Message, type MessageParams, wordsOf } from "../../store/messages";
import type { TelemetryStore } from "../../store/telemetry";

export type AlarmLevel = Alarm["level"];

/** The alarm that the page raises itself: it does not hear the gateway. */
export const GATEWAY_LOST = "gateway_lost";
/** The one that it makes of the event of this name. */
export const BOARD_RESTARTED = "board_restarted";

/**
 * An unexpected restart of the board. It does not end by itself, only by being acknowledged. Unix seconds of the
 * gateway; `params` name what is lost.
 */
export interface BoardRestart {
  readonly since_s: number;
  readonly params: MessageParams;
}

/** Whether the page raised an alarm itself: it is acknowledged here, without a request. */
export function isOwn(id: string): boolean {
  return id === GATEWAY_LOST || id === BOARD_RESTARTED;
}

/** The page's own alarm. Unix seconds, this browser's clock. */
export interface OwnAlarm {
  readonly since_s: number;
  readonly acknowledged: boolean;
}

/** One active alarm. `since_s` is Unix time of the side that raised it. */
export interface ActiveAlarm {
  readonly id: string;
  readonly level: AlarmLevel;
  readonly since_s: number;
  readonly acknowledged: boolean;
  /** How often it came since it was last acknowledged. */
  readonly count: number;
  readonly message: Message;
}

type HilStatus = NonNullable<Connection["status"]>["simulator"];

type Variant = (params: Readonly<Record<string, unknown>>, simulator: HilStatus | null) => string;

const ceiling: Variant = ({ what }) => (what === "ceiling" ? "_ceiling" : "");

/** Alarms with more than one sentence: what is added to the key of the first. */
const VARIANTS: Readonly<Record<string, Variant>> = {
  // The gateway has one alarm for the HIL loop; which end is open follows from the states of the two ends.
  hil_lost: (params, simulator) => {
    if ("row" in params) {
      return "_value";
    }
    if (simulator === null) {
      return "";
    }
    return simulator.state !== "open" ? "_simulator" : simulator.missing_rows.length > 0 ? "_rows" : "";
  },
  gps_lost: ({ reason }) => (reason === "silent" ? "_silent" : ""),
  // The recordings of earlier versions do not tell the cells.
  battery_low: (params) => ("cells" in params ? "_cells" : ""),
  fence_ahead: ceiling,
  fence_left: ceiling,
  // What is not watched any more, and whether the aircraft was outside the fence when it last was.
  surroundings_unwatched: ({ what, was_left }) => {
    if (was_left === true) {
      return "_left";
    }
    return what === "terrain" || what === "fence" || what === "unknown" ? `_${what}` : "";
  },
  [BOARD_RESTARTED]: (params) => `${"gains" in params ? "_gains" : ""}${"plans" in params ? "_plans" : ""}`,
};

/** The sentence of an alarm; `text` is the gateway's own, for an alarm that this page does not know. */
export function alarmMessage(
  {
    id,
    text,
    params,
  }: { readonly id: string; readonly text: string; readonly params: Readonly<Record<string, unknown>> },
  simulator: HilStatus | null,
): Message {
  const rows = simulator?.missing_rows.join(", ") ?? "";
  return {
    level: "warning",
    key: `alarm.${id}${VARIANTS[id]?.(params, simulator) ?? ""}`,
    params: { ...wordsOf(params), rows },
    fallback: text,
  };
}

/**
 * The active alarms, the most urgent first. Without the gateway its alarms are unknown: only its loss is active, and
 * the board's restart, which stays true.
 */
export function activeAlarms(
  { phase, status }: Pick<Connection, "phase" | "status">,
  own: OwnAlarm | null,
  restart: BoardRestart | null = null,
): readonly ActiveAlarm[] {
  const restarted = restart === null ? [] : [restartAlarm(restart)];
  if (own !== null) {
    const key = phase === "silent" ? "alarm.gateway_silent" : "alarm.gateway_lost";
    const message: Message = { level: "error", key, params: {} };
    return [{ id: GATEWAY_LOST, level: "critical", ...own, count: 1, message }, ...restarted];
  }
  if (phase !== "open" || status === null) {
    return restarted;
  }
  const told = status.alarms.filter(isLasting).map(
    (alarm): ActiveAlarm => ({
      id: alarm.id,
      level: alarm.level,
      since_s: alarm.since_s,
      acknowledged: alarm.acknowledged,
      count: alarm.count,
      message: alarmMessage(alarm, status.simulator),
    }),
  );
  return [...told, ...restarted].sort(
    (first, second) => urgency(first) - urgency(second) || second.since_s - first.since_s,
  );
}

/** The gateway also lists recovered alarms, until somebody acknowledges them. */
function isLasting({ until_s }: Alarm): boolean {
  return until_s === null;
}

function restartAlarm({ since_s, params }: BoardRestart): ActiveAlarm {
  const message = alarmMessage({ id: BOARD_RESTARTED, text: "", params }, null);
  return { id: BOARD_RESTARTED, level: "critical", since_s, acknowledged: false, count: 1, message };
}

/** 0 is the most urgent: unacknowledged before acknowledged, then critical before warning. */
function urgency({ acknowledged, level }: ActiveAlarm): number {
  return (acknowledged ? 2 : 0) + (level === "critical" ? 0 : 1);
}

interface Facts {
  readonly status: NonNullable<Connection["status"]>;
  readonly damagedLastSecond: number;
  readonly telemetry: TelemetryStore;
  readonly now_ms: number;
}

/**
 * The proof that an ended alarm has recovered. An alarm also ends because a link was closed or a stream stopped: that
 * proves nothing. An id without a proof never counts as recovered.
 */
const PROOFS: Readonly<Record<string, (facts: Facts) => boolean>> = {
  [GATEWAY_LOST]: () => true,
  flight_lost: () => true,
  heartbeat_lost: (facts) => facts.status.board.state === "open" && isFresh("heartbeat", facts),
  no_heartbeat: (facts) => facts.status.board.state === "open" && isFresh("heartbeat", facts),
  hil_lost: (facts) => facts.status.simulator.state === "open" && isFresh("hil_surfaces", facts),
  line_floods: (facts) => isFresh("heartbeat", facts),
  profile_wrong: ({ status: { simulator } }) =>
    simulator.state === "open" && simulator.fitting_profile === simulator.profile,
  simulator_paused: (facts) => facts.status.simulator.state === "open" && isFresh("simulator", facts),
  frames_damaged: (facts) => facts.damagedLastSecond === 0 && isFresh("heartbeat", facts),
  recorder_failed: ({ status }) => status.recording.active && status.recording.failure === null,
  battery_low: (facts) => isFresh("analog", facts),
  gps_lost: (facts) => isFresh("gps", facts) && facts.telemetry.newestFlag("gps", "valid") === true,
  terrain_ahead: (facts) => sees(facts, ({ height_ft }) => height_ft !== null),
  fence_ahead: (facts) => sees(facts, ({ blind }) => blind !== "no_position"),
  fence_left: (facts) => sees(facts, ({ blind }) => blind !== "no_position"),
  surroundings_unwatched: (facts) => sees(facts, ({ blind }) => blind !== "no_position"),
  cpu_high: (facts) => isFresh("statistics", facts),
  receiver_lost: (facts) => isFresh("servos_in", facts),
  altitude_high: (facts) => isFresh("analog", facts),
  airspeed_low: (facts) => isFresh("analog", facts),
  airspeed_high: (facts) => isFresh("analog", facts),
  distance_far: (facts) => isFresh("gps", facts) && facts.telemetry.newestFlag("gps", "valid") === true,
  satellites_few: (facts) => isFresh("gps", facts),
};

/** Whether the station still sees, around one of the aircraft, what the alarm was of. */
function sees({ status }: Facts, isSeen: (around: AircraftAround) => boolean): boolean {
  return isSeen(status.surroundings.flight) || isSeen(status.surroundings.hil);
}

/**
 * Whether the newest sample is at most one and a half periods old. "Live" is not enough: when a stream stops, its
 * alarm ends while its last sample still counts as live.
 */
function isFresh(topic: TopicName, { status, telemetry, now_ms }: Facts): boolean {
  const age_s = telemetry.age_s(topic, now_ms);
  const limit_s = status.topics[topic]?.stale_after_s;
  return limit_s != null && age_s !== null && age_s < limit_s / 2;
}

/** Whether an ended alarm is proven to have recovered: its end alone is no proof. */
export function isRecovered(
  id: string,
  { phase, status, damagedLastSecond }: Connection,
  telemetry: TelemetryStore,
  now_ms: number,
): boolean {
  return (
    phase === "open" &&
    status !== null &&
    !status.alarms.some((alarm) => alarm.id === id && isLasting(alarm)) &&
    PROOFS[id]?.({ status, damagedLastSecond, telemetry, now_ms }) === true
  );
}

/** A moment of an alarm that came more than once, with how often it came. */
export function withCount(moment: string, count: number): string {
  return count > 1 ? `${moment} × ${count}` : moment;
}
