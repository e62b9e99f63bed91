import { plain } from "../../lib/plain";
import type { FlightEvent } from "../../protocol/guards.gen";
import type { Message, MessageLevel, SaidMessage } from "../../store/messages";
import type { EventMessage, LogGroup } from "./flightLog";

/** One line of the log. */
export interface LogRow {
  readonly key: string;
  /** Unix seconds. */
  readonly at_s: number;
  readonly group: LogGroup;
  readonly level: MessageLevel;
  readonly text: string;
}

export interface LogFilter {
  readonly hidden: readonly LogGroup[];
  /** The mildest level that is shown. */
  readonly least: MessageLevel;
  /** Words that a line must hold, each of them, in any order; accents and case do not matter. */
  readonly search: string;
}

export const EVERYTHING: LogFilter = { hidden: [], least: "info", search: "" };
export const LEVELS = ["info", "warning", "error"] as const satisfies readonly MessageLevel[];

/** A command's outcome is said by the page and recorded by the station: within this time they are the same. */
const SAME_S = 3;

/** What the page said and what was recorded, newest first; what both tell stands once, as it was recorded. */
export function logRows(
  said: readonly SaidMessage[],
  events: readonly FlightEvent[],
  tell: (event: FlightEvent) => EventMessage,
  sentence: (message: Message) => string,
): readonly LogRow[] {
  const recorded = events.map((event, index): LogRow => {
    const { group, message } = tell(event);
    return {
      key: `e${index}`,
      at_s: event.t_s,
      group,
      level: levelOf(event, group, message),
      text: sentence(message),
    };
  });
  const times = new Map<string, number[]>();
  for (const { text, at_s } of recorded) {
    times.set(text, [...(times.get(text) ?? []), at_s]);
  }
  const own = said
    .map(
      (message): LogRow => ({
        key: `m${message.number}`,
        at_s: message.said_ms / 1000,
        group: "page",
        level: message.level,
        text: sentence(message),
      }),
    )
    .filter(({ text, at_s }) => !times.get(text)?.some((time_s) => Math.abs(time_s - at_s) < SAME_S));
  return [...recorded, ...own].sort((first, second) => second.at_s - first.at_s);
}

/** The rows that pass the filter. */
export function filtered(rows: readonly LogRow[], { hidden, least, search }: LogFilter): readonly LogRow[] {
  const words = plain(search).split(/\s+/).filter(Boolean);
  return rows.filter(
    ({ group, level, text }) =>
      !hidden.includes(group) &&
      LEVELS.indexOf(level) >= LEVELS.indexOf(least) &&
      words.every((word) => plain(text).includes(word)),
  );
}

/** As a file of text, oldest first: local time, level, group, sentence, with tabs between. */
export function logFile(
  rows: readonly LogRow[],
  words: {
    readonly time: (at_s: number) => string;
    readonly level: (level: MessageLevel) => string;
    readonly group: (group: LogGroup) => string;
  },
): string {
  return [...rows]
    .reverse()
    .map(({ at_s, level, group, text }) =>
      [words.time(at_s), words.level(level), words.group(group), text.replace(/\s+/g, " ")].join("\t"),
    )
    .join("\n")
    .concat("\n");
}

function levelOf({ kind, name, data }: FlightEvent, group: LogGroup, message: Message): MessageLevel {
  if (group === "alarm") {
    return data["level"] === "critical" ? "error" : data["level"] === "warning" ? "warning" : "info";
  }
  // A line that was opened is no trouble, and one that was closed may be.
  return group === "trouble" && !(kind === "link" && name.endsWith("_opened")) ? "warning" : message.level;
}
