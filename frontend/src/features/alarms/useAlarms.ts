import { useMemo } from "react";
import { useStore } from "zustand";
import { useSentence } from "../../i18n/useSentence";
import { useGatewayBlocked } from "../../requests/useBlocked";
import { useConnection, usePart, useTelemetry } from "../../store/hooks";
import type { AlarmLogState } from "./alarmLog";
import { ALARM_LOG } from "./alarmLog";
import { type EndedAlarm, endedAlarms } from "./endedAlarms";
import { type ActiveAlarm, activeAlarms, isOwn } from "./raisedAlarms";

interface Acknowledgeable {
  /** Why this page may not acknowledge it; undefined where it may. */
  readonly blocked: string | undefined;
}

export interface AlarmView extends ActiveAlarm, Acknowledgeable {
  readonly text: string;
}

/** One value of the alarm log; the component renders again when it changes. */
export function useAlarmLogState<T>(select: (state: AlarmLogState) => T): T {
  return useStore(usePart(ALARM_LOG).store, select);
}

/** The active alarms in the page's language, the most urgent first. */
export function useActiveAlarms(): readonly AlarmView[] {
  const sentence = useSentence();
  const phase = useConnection((connection) => connection.phase);
  const status = useConnection((connection) => connection.status);
  const own = useAlarmLogState((state) => state.own);
  const restart = useAlarmLogState((state) => state.restart);
  const blocked = useGatewayBlocked();
  return useMemo(
    () =>
      activeAlarms({ phase, status }, own, restart).map((alarm) => ({
        ...alarm,
        text: sentence(alarm.message),
        // The page's own alarms need no request; the gateway's are acknowledged for everybody, by the client in
        // control.
        blocked: isOwn(alarm.id) ? undefined : blocked,
      })),
    [phase, status, own, restart, sentence, blocked],
  );
}

export interface EndedAlarmView extends EndedAlarm, Acknowledgeable {
  /** Its name in the page's language. */
  readonly name: string;
}

/** Alarms that ended before anybody acknowledged them, newest first. */
export function useEndedAlarms(): readonly EndedAlarmView[] {
  const sentence = useSentence();
  const phase = useConnection((connection) => connection.phase);
  const status = useConnection((connection) => connection.status);
  const own = useAlarmLogState((state) => state.ownEnded);
  const blocked = useGatewayBlocked();
  return useMemo(
    () =>
      endedAlarms({ phase, status }, own).map((alarm) => ({
        ...alarm,
        name: sentence({ level: "info", key: `alarmName.${alarm.id}`, params: {}, fallback: alarm.text }),
        blocked: isOwn(alarm.id) ? undefined : blocked,
      })),
    [phase, status, own, sentence, blocked],
  );
}

/** Why these alarms cannot all be acknowledged at once; undefined if they can. */
export function blockedAmong(alarms: readonly Acknowledgeable[]): string | undefined {
  return alarms.find(({ blocked }) => blocked !== undefined)?.blocked;
}

/** Whole seconds for which the alarms stay mute; null while they are not. */
export function useMutedFor_s(): number | null {
  const until_ms = useAlarmLogState((state) => state.mutedUntil_ms);
  return useTelemetry((_telemetry, now_ms) =>
    until_ms === null ? null : Math.max(0, Math.ceil((until_ms - now_ms) / 1000)),
  );
}
