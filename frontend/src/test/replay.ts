import type { Status } from "../protocol/contract";
import { FIELD_KINDS } from "../protocol/topics";
import type { WireListener } from "../transport/socket";
import { aStatus } from "./aStatus";
import { ManualWire } from "./wire";

export const FLIGHT = "20231114T221320Z";
/** Unix seconds of that flight's start. */
export const FLIGHT_STARTS_S = 1_699_999_000;

interface Position {
  readonly at_s: number;
  readonly state: "playing" | "paused" | "ended";
  readonly rate: number;
  readonly loop: readonly [number, number] | null;
  readonly jumps: number;
}

/** The gateway's stream of a flight of the past, under the test's control. */
export class FakeReplay {
  readonly wire: ManualWire;
  readonly place: { readonly flight: string; readonly at_s: number };
  readonly duration_s = 600;
  #position: Position;
  #seq = 0;

  constructor(place: { readonly flight: string; readonly at_s: number }, listener: WireListener) {
    this.wire = new ManualWire(listener);
    this.place = place;
    this.#position = { at_s: place.at_s, state: "paused", rate: 1, loop: null, jumps: 1 };
  }

  /** What the page wants of it, without acknowledgements and questions. */
  get asked(): ReadonlyArray<Readonly<Record<string, unknown>>> {
    return this.#sent.filter(({ type }) => type !== "ack" && type !== "ask");
  }

  /** What the page asked about the moments that it showed. */
  get questions(): readonly unknown[] {
    return this.#sent.filter(({ type }) => type === "ask").map(({ about }) => about);
  }

  get #sent(): ReadonlyArray<Readonly<Record<string, unknown>>> {
    return this.wire.sent.map((text) => JSON.parse(text) as Record<string, unknown>);
  }

  answer(about: string, data: unknown): void {
    this.wire.deliver({ type: "answer", about, data });
  }

  greet(status: Status = aStatus()): void {
    this.wire.deliver({
      type: "hello",
      version: "0.1.0",
      client: "replay-1",
      role: "viewer",
      server_time_s: this.t_s,
      topics: [],
      flight: FLIGHT,
      starts_s: FLIGHT_STARTS_S,
      duration_s: this.duration_s,
      status,
    });
    this.position({});
  }

  /** Where it stands now, with some parts changed. */
  position(change: Partial<Position>): void {
    this.#position = { ...this.#position, ...change };
    this.wire.deliver({
      type: "playback",
      flight: FLIGHT,
      t_s: this.t_s,
      duration_s: this.duration_s,
      edge_s: this.duration_s,
      ...this.#position,
    });
  }

  /** The newest values of some topics at the moment at which it stands; fields not given are no data. */
  send(values: Readonly<Record<string, Readonly<Record<string, number | boolean | null>>>>): void {
    this.#seq += 1;
    const samples = Object.entries(values).map(([topic, known]) => ({
      topic,
      t_s: this.t_s,
      values: Object.fromEntries(
        (FIELD_KINDS.get(topic) ?? []).map(([field]) => [field, known[field] ?? null]),
      ),
    }));
    this.wire.deliver({ type: "batch", seq: this.#seq, t_s: this.t_s, samples });
  }

  get t_s(): number {
    return FLIGHT_STARTS_S + this.#position.at_s;
  }
}
