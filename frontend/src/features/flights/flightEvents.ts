import type { FlightEvent } from "../../protocol/guards.gen";
import { resultMessage } from "../../requests/actions";
import { info } from "../../requests/asking";
import { THIS_COMPUTER } from "../../requests/useControl";
import { adviceMessage } from "../../store/advice";
import { type Message, wordsOf } from "../../store/messages";

/** The groups by which events are chosen, in the order of the switches. */
export const EVENT_GROUPS = ["command", "alarm", "advice", "mode", "waypoint", "mark", "trouble"] as const;
export type EventGroup = (typeof EVENT_GROUPS)[number];

const GROUP_OF: Readonly<Record<string, EventGroup>> = {
  command: "command",
  parameter: "command",
  plan: "command",
  limits: "command",
  console: "command",
  alarm: "alarm",
  advice: "advice",
  mode: "mode",
  control: "mode",
  jump: "mode",
  stick: "mode",
  wind: "mode",
  waypoint: "waypoint",
  mark: "mark",
};

/** What is of no other group went wrong: gaps, damage, lines and recordings that were lost, restarts, faults. */
export function groupOf({ kind }: Pick<FlightEvent, "kind">): EventGroup {
  return GROUP_OF[kind] ?? "trouble";
}

/** What happened, as a sentence. */
export function eventMessage(event: FlightEvent): Message {
  const { kind, name, data } = event;
  switch (kind) {
    case "command":
      return commandMessage(event);
    case "alarm":
      return {
        ...info(`alarm.${name}`, wordsOf(objectOf(data["params"]))),
        fallback: textOf(data["text"], name),
      };
    case "advice":
      return adviceMessage(name, { level: data["level"], text: data["text"], params: data["params"] });
    case "mark":
      return info("flightEvent.mark", { text: textOf(data["text"], "") });
    case "mode":
      return modeMessage(event);
    case "waypoint":
      return info("flightEvent.waypoint", {
        plan: `@flightPlan.${name}`,
        from: numberOf(data["from"]),
        to: numberOf(data["to"]),
      });
    case "plan":
      return info("flightEvent.plan", { plan: `@flightPlan.${name}` });
    case "console":
      return info("flightEvent.console", { text: textOf(data["text"] ?? data["line"], name) });
    case "control":
      return controlMessage(event);
    case "parameter":
      return info("flightEvent.parameter", { names: parameterNames(data) });
    case "link":
      return name === ""
        ? info("flightEvent.lines", {
            board: linkWord(data["board"]),
            simulator: linkWord(data["simulator"]),
          })
        : { ...info(`flightLink.${name}`), fallback: name };
    case "lost":
      return info("flightEvent.lost", {
        bytes: numberOf(data["bytes"]),
        reason: textOf(data["reason"], name),
      });
    case "jump":
      return info("flightEvent.jump", { distance_m: numberOf(data["distance_m"]) });
    case "stick":
      return stickMessage(event);
    case "fault":
      return info(data["state"] === "ended" ? "flightEvent.faultEnded" : "flightEvent.faultBegun", {
        place: `@faultPlace.${name}`,
        kind: `@faultKind.${textOf(data["kind"], "")}`,
      });
    case "wind":
      return info("flightEvent.wind", {
        from_deg: numberOf(data["from_deg"]),
        speed_kt: numberOf(data["speed_kt"]),
        turbulence: `@turbulence.${textOf(data["turbulence"], "none")}`,
      });
    case "limits":
      return info("flightEvent.limits", {
        name: `@alarmThreshold.${name}`,
        before: numberOf(data["before"]),
        after: numberOf(data["after"]),
      });
    case "gap":
      return name === "simulator" ? info("flightEvent.simulatorGap") : info("flightEvent.gap");
    default:
      return { ...info(`flightEvent.${kind}`), fallback: `${kind} ${name}` };
  }
}

function commandMessage({ name, data }: FlightEvent): Message {
  const what = `@command.${name}`;
  const { state, by, reason, ms } = data;
  switch (state) {
    case "confirmed":
    case "sent":
    case "rejected":
    case "timed_out":
      return resultMessage(what, {
        state,
        by: textOf(by, "acknowledgement"),
        reason: reason === null || reason === undefined ? null : textOf(reason, ""),
        ms: numberOf(ms),
      });
    default:
      // The recording ends before the board answered.
      return info("flightEvent.pending", { what });
  }
}

function modeMessage({ name, data }: FlightEvent): Message {
  const isOn = data["on"] === true;
  if (name === "assisted") {
    return info(isOn ? "flightEvent.assisted" : "flightEvent.manual");
  }
  return info(isOn ? "flightEvent.modeOn" : "flightEvent.modeOff", { mode: `@flightMode.${name}` });
}

function controlMessage({ name }: FlightEvent): Message {
  return name === ""
    ? info("flightEvent.nobody")
    : info("flightEvent.control", { name: name === THIS_COMPUTER ? "@control.station" : name });
}

function stickMessage({ name, data }: FlightEvent): Message {
  if (name !== "gamepad") {
    return info("flightEvent.stickSimulator");
  }
  const gamepad = textOf(data["gamepad"], "?");
  return info(data["state"] === "lost" ? "flightEvent.stickLost" : "flightEvent.stickGamepad", { gamepad });
}

/** An event of gains has each that changed by its name. */
function parameterNames(data: FlightEvent["data"]): string {
  const names = Object.keys(objectOf(data["parameters"]));
  return names.length === 0 ? "?" : names.join(", ");
}

function objectOf(value: unknown): Readonly<Record<string, unknown>> {
  return typeof value === "object" && value !== null ? (value as Record<string, unknown>) : {};
}

/** A line's state, by its name in the catalogue. */
function linkWord(state: unknown): string {
  return `@link.${textOf(state, "unknown")}`;
}

function textOf(value: unknown, otherwise: string): string {
  return typeof value === "string" ? value : otherwise;
}

function numberOf(value: unknown): number {
  return typeof value === "number" ? value : 0;
}
