import type { Connection } from "../../store/connection";
import type { AlarmLevel } from "./raisedAlarms";

/** An alarm that is over and that nobody has acknowledged. Unix seconds; `text` as whoever raised it says it. */
export interface EndedAlarm {
  readonly id: string;
  readonly level: AlarmLevel;
  readonly text: string;
  readonly until_s: number;
}

/**
 * What is over and not acknowledged, newest first: the gateway's, which lists it until somebody acknowledges it, and
 * the page's own. Without the gateway the page's own alone.
 */
export function endedAlarms(
  { phase, status }: Pick<Connection, "phase" | "status">,
  own: EndedAlarm | null,
): readonly EndedAlarm[] {
  const told = phase === "open" ? (status?.alarms ?? []) : [];
  const ended = told.flatMap(({ id, level, text, until_s }): readonly EndedAlarm[] =>
    until_s === null ? [] : [{ id, level, text, until_s }],
  );
  return [...ended, ...(own === null ? [] : [own])].sort((first, second) => second.until_s - first.until_s);
}
