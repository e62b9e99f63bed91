import type { Alarm } from "../../protocol/status";
import type { AlarmLevel } from "./raisedAlarms";

/** An alarm that is over and that nobody has acknowledged. Unix seconds; `text` as whoever raised it says it. */
export interface EndedAlarm {
  readonly id: string;
  readonly level: AlarmLevel;
  readonly text: string;
  readonly until_s: number;
}

/** More than anybody looks through in the strip: the list of past alarms has them all. */
const KEPT = 20;

/** The unacknowledged alarms of one status that the next one does not have any more. */
export function endedBetween(
  before: readonly Alarm[],
  now: readonly Alarm[],
  until_s: number,
): readonly EndedAlarm[] {
  return before
    .filter(({ id, acknowledged }) => !(acknowledged || now.some((alarm) => alarm.id === id)))
    .map(({ id, level, text }) => ({ id, level, text, until_s }));
}

/** `kept` with `news`, newest first and one for each alarm; what is raised again is seen as an alarm itself. */
export function withEnded(
  kept: readonly EndedAlarm[],
  news: readonly EndedAlarm[],
  active: readonly string[],
): readonly EndedAlarm[] {
  const newer = [...news.map(({ id }) => id), ...active];
  const old = kept.filter(({ id }) => !newer.includes(id));
  return news.length === 0 && old.length === kept.length ? kept : [...news, ...old].slice(0, KEPT);
}
