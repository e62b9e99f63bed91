import { useMemo } from "react";
import { useStore } from "zustand";
import { useSentence } from "../i18n/useSentence";
import type { AlarmBookState } from "../store/alarmBook";
import { type ActiveAlarm, activeAlarms, isOwn } from "../store/alarms";
import type { EndedAlarm } from "../store/endedAlarms";
import { useConnection, usePage, useTelemetry } from "../store/hooks";
import { useGatewayBlocked } from "./useBlocked";

export interface ShownAlarm extends ActiveAlarm {
  readonly text: string;
  /** Why this page may not acknowledge it; undefined where it may. */
  readonly blocked: string | undefined;
}

/** One thing of the alarm book; the component renders again when it changes. */
export function useAlarmBook<T>(select: (state: AlarmBookState) => T): T {
  return useStore(usePage().alarmBook.store, select);
}

/** What is wrong now, in the page's language, the most urgent first. */
export function useActiveAlarms(): readonly ShownAlarm[] {
  const sentence = useSentence();
  const phase = useConnection((connection) => connection.phase);
  const status = useConnection((connection) => connection.status);
  const own = useAlarmBook((state) => state.own);
  const restart = useAlarmBook((state) => state.restart);
  const blocked = useGatewayBlocked();
  return useMemo(
    () =>
      activeAlarms({ phase, status }, own, restart).map((alarm) => ({
        ...alarm,
        text: sentence(alarm.message),
        // The page's own alarms ask nobody; the gateway's are acknowledged for everybody, by whoever has control.
        blocked: isOwn(alarm.id) ? undefined : blocked,
      })),
    [phase, status, own, restart, sentence, blocked],
  );
}

export interface ShownEnded extends EndedAlarm {
  /** What it is called, in the page's language. */
  readonly name: string;
}

/** Alarms that ended before anybody acknowledged them, newest first. */
export function useEndedAlarms(): readonly ShownEnded[] {
  const sentence = useSentence();
  const ended = useAlarmBook((state) => state.ended);
  return useMemo(
    () =>
      ended.map((alarm) => ({
        ...alarm,
        name: sentence({ level: "info", key: `alarmName.${alarm.id}`, params: {}, fallback: alarm.text }),
      })),
    [ended, sentence],
  );
}

/** Whole seconds for which the alarms stay mute; null while they are not. */
export function useMutedFor_s(): number | null {
  const until_ms = useAlarmBook((state) => state.mutedUntil_ms);
  return useTelemetry((_telemetry, now_ms) =>
    until_ms === null ? null : Math.max(0, Math.ceil((until_ms - now_ms) / 1000)),
  );
}
