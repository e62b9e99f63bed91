import type { FlightEvent } from "../../protocol/guards.gen";

/** The lanes of the time bar, from top to bottom. */
export const LANES = ["command", "mode", "alarm", "waypoint", "mark"] as const;
export type Lane = (typeof LANES)[number];

/** The lane of each kind of event. What belongs to a line or a recording that was lost or damaged stands with the alarms. */
const LANE_OF: Readonly<Record<string, Lane>> = {
  command: "command",
  console: "command",
  parameter: "command",
  plan: "command",
  limits: "command",
  mode: "mode",
  control: "mode",
  jump: "mode",
  stick: "mode",
  wind: "mode",
  alarm: "alarm",
  damage: "alarm",
  fault: "alarm",
  link: "alarm",
  lost: "alarm",
  restart: "alarm",
  waypoint: "waypoint",
  mark: "mark",
};

/** The lane of an event; null if it has none: a gap is drawn as a gap. */
export function laneOf({ kind }: Pick<FlightEvent, "kind">): Lane | null {
  return LANE_OF[kind] ?? null;
}

/** An alarm that ended sooner is a blink: drawn, but nothing to go to. */
const BRIEF_S = 0.5;

function isBrief({ kind, t_s, until_s }: FlightEvent): boolean {
  return kind === "alarm" && until_s !== null && until_s - t_s < BRIEF_S;
}

/** The first event after this moment, of those that have a lane and are no blink. */
export function eventAfter(events: readonly FlightEvent[], at_s: number): FlightEvent | null {
  return best(events, (event) => event.at_s > at_s, -1);
}

/** The last event before this moment. */
export function eventBefore(events: readonly FlightEvent[], at_s: number): FlightEvent | null {
  return best(events, (event) => event.at_s < at_s, 1);
}

function best(
  events: readonly FlightEvent[],
  isMeant: (event: FlightEvent) => boolean,
  direction: 1 | -1,
): FlightEvent | null {
  let found: FlightEvent | null = null;
  for (const event of events) {
    if (
      laneOf(event) !== null &&
      !isBrief(event) &&
      isMeant(event) &&
      (found === null || (event.at_s - found.at_s) * direction > 0)
    ) {
      found = event;
    }
  }
  return found;
}
