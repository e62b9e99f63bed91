import type { Connection } from "../../store/connection";
import type { AlarmLevel } from "./raisedAlarms";

/** An alarm that ended unacknowledged. Unix seconds; `text` in the words of the side that raised it. */
export interface EndedAlarm {
  readonly id: string;
  readonly level: AlarmLevel;
  readonly text: string;
  readonly until_s: number;
  /** How often it came since it was last acknowledged. */
  readonly count: number;
}

/**
 * The ended alarms that are not acknowledged, newest first: the gateway's, which lists them until they are, and the
 * page's own. Without the gateway only the page's own.
 */
export function endedAlarms(
  { phase, status }: Pick<Connection, "phase" | "status">,
  own: EndedAlarm | null,
): readonly EndedAlarm[] {
  const told = phase === "open" ? (status?.alarms ?? []) : [];
  const ended = told.flatMap(({ id, level, text, until_s, count }): readonly EndedAlarm[] =>
    until_s === null ? [] : [{ id, level, text, until_s, count }],
  );
  return [...ended, ...(own === null ? [] : [own])].sort((first, second) => second.until_s - first.until_s);
}
