import { type Checked, dictionary, isNumber, isObject, isText, list, nullable, oneOf } from "../lib/check";
import { EVENT_CHECKS, isPlayback, isStatus, type Playback, type Status } from "./guards.gen";
import { FIELD_KINDS } from "./topics";

/** One message of a topic: when the gateway had it (Unix seconds of its clock) and what it said; null is "no data". */
export interface Sample {
  readonly topic: string;
  readonly t_s: number;
  readonly values: Readonly<Record<string, number | boolean | null>>;
}

/** All rows of the simulator that are not old, by number: eight values each, null where a row has none. */
export interface SimulatorRows {
  readonly t_s: number;
  readonly rows: ReadonlyArray<readonly [row: number, values: ReadonlyArray<number | null>]>;
}

export interface Hello {
  readonly type: "hello";
  readonly version: string;
  /** Name of this connection; commands carry it. */
  readonly client: string;
  readonly role: "viewer" | "operator" | "owner";
  readonly server_time_s: number;
  readonly status: Status;
  /** The flight that is played back; null on the live stream. */
  readonly flight: { readonly id: string; readonly starts_s: number; readonly duration_s: number } | null;
}

/** The flight that is to be played back is being opened; its hello follows. */
export interface Opening {
  readonly type: "opening";
}

export interface PlaybackMessage {
  readonly type: "playback";
  readonly position: Playback;
}

export interface Batch {
  readonly type: "batch";
  readonly seq: number;
  readonly t_s: number;
  readonly samples: readonly Sample[];
  /** The newest of them, where the batch brings any. */
  readonly rows: SimulatorRows | null;
}

export interface StatusMessage {
  readonly type: "status";
  readonly data: Status;
}

type EventName = keyof typeof EVENT_CHECKS;

/** Something that happened, by its name; null is an event of a newer gateway, which this page does not know. */
export type StreamEvent =
  | {
      readonly [N in EventName]: {
        readonly type: "event";
        readonly event: N;
        readonly t_s: number;
        readonly data: Checked<(typeof EVENT_CHECKS)[N]>;
      };
    }[EventName]
  | { readonly type: "event"; readonly event: null; readonly t_s: number; readonly data: unknown };

/** What was asked about the moment of a flight that is shown. Whoever asked checks what it is. */
export interface AnswerMessage {
  readonly type: "answer";
  readonly about: string;
  readonly data: unknown;
}

export type StreamMessage =
  | Hello
  | Opening
  | Batch
  | StatusMessage
  | StreamEvent
  | PlaybackMessage
  | AnswerMessage;

/** What a text off the socket says, or null when any part of it is not as agreed. */
export function parseMessage(text: string): StreamMessage | null {
  let value: unknown;
  try {
    value = JSON.parse(text);
  } catch {
    return null;
  }
  if (isObject(value)) {
    switch (value["type"]) {
      case "batch":
        return batch(value);
      case "status":
        return isStatus(value["data"]) ? { type: "status", data: value["data"] } : null;
      case "event":
        return event(value);
      case "hello":
        return hello(value);
      case "opening":
        return { type: "opening" };
      case "playback":
        return isPlayback(value) ? { type: "playback", position: value } : null;
      case "answer":
        return isText(value["about"]) ? { type: "answer", about: value["about"], data: value["data"] } : null;
      default:
        return null;
    }
  }
  return null;
}

/** The number of a batch, whose other parts may be malformed; null if it is no batch. */
export function batchNumber(text: string): number | null {
  try {
    const value: unknown = JSON.parse(text);
    return isObject(value) && value["type"] === "batch" && isNumber(value["seq"]) ? value["seq"] : null;
  } catch {
    return null;
  }
}

type Json = Readonly<Record<string, unknown>>;

const isRole = oneOf("viewer", "operator", "owner");

function hello(value: Json): Hello | null {
  const { version, client, role, server_time_s, status } = value;
  const flight = flightOf(value);
  return isText(version) &&
    isText(client) &&
    isRole(role) &&
    isNumber(server_time_s) &&
    isStatus(status) &&
    flight !== undefined
    ? { type: "hello", version, client, role, server_time_s, status, flight }
    : null;
}

/** The flight of a hello; null if it names none, undefined if it is malformed. */
function flightOf({ flight, starts_s, duration_s }: Json): Hello["flight"] | undefined {
  if (flight == null) {
    return null;
  }
  return isText(flight) && isNumber(starts_s) && isNumber(duration_s)
    ? { id: flight, starts_s, duration_s }
    : undefined;
}

function event({ event: name, t_s, data }: Json): StreamEvent | null {
  if (!(isText(name) && isNumber(t_s) && isObject(data))) {
    return null;
  }
  if (!Object.hasOwn(EVENT_CHECKS, name)) {
    return { type: "event", event: null, t_s, data };
  }
  // The check found by the name is the one of this name's data, which the compiler cannot follow.
  return EVENT_CHECKS[name as EventName](data)
    ? ({ type: "event", event: name, t_s, data } as StreamEvent)
    : null;
}

const ROWS_TOPIC = "xplane_rows";
/** X-Plane's "this value is not here". */
const ABSENT = -999;
const isRows = dictionary(list(nullable(isNumber)));

function batch(value: Json): Batch | null {
  const { seq, t_s, samples } = value;
  if (!(isNumber(seq) && isNumber(t_s) && Array.isArray(samples))) {
    return null;
  }
  const known: Sample[] = [];
  let rows: SimulatorRows | null = null;
  for (const sample of samples) {
    if (isObject(sample) && sample["topic"] === ROWS_TOPIC) {
      rows = simulatorRows(sample);
      if (rows === null) {
        return null;
      }
    } else if (isSample(sample)) {
      known.push(sample);
    } else {
      return null;
    }
  }
  return { type: "batch", seq, t_s, samples: known, rows };
}

function simulatorRows({ t_s, values }: Json): SimulatorRows | null {
  if (!(isNumber(t_s) && isObject(values) && isRows(values["rows"]))) {
    return null;
  }
  const rows = Object.entries(values["rows"]).map(
    ([row, eight]) => [Number(row), eight.map((entry) => (entry === ABSENT ? null : entry))] as const,
  );
  return rows.every(([row]) => Number.isInteger(row)) ? { t_s, rows } : null;
}

function isSample(value: unknown): value is Sample {
  if (!(isObject(value) && isText(value["topic"]) && isNumber(value["t_s"]) && isObject(value["values"]))) {
    return false;
  }
  const values = value["values"];
  // A topic that this page does not know may hold anything: who reads it looks at each value.
  for (const [field, kind] of FIELD_KINDS.get(value["topic"]) ?? []) {
    const entry = values[field];
    if (entry !== null && (typeof entry !== kind || (kind === "number" && !Number.isFinite(entry)))) {
      return false;
    }
  }
  return true;
}
