import type { Sample, SimulatorRows } from "../protocol/envelope";
import type { FlagField, NumberField, TopicName } from "../protocol/topics";
import { FlightClock, ServerClock, type VehicleClock } from "./clock";

/** `live`: recent. `stale`: received too long ago. `none`: never received. */
export type DataState = "live" | "stale" | "none";

/** A gateway that is silent for this long counts as lost: it sends its status twice a second. */
export const SILENCE_MS = 1000;
/** Default, until the gateway has sent each topic's limit. */
const DEFAULT_STALE_AFTER_S = 1;
/**
 * Extra age allowed for transport and display: one batch, the network, one animation frame. Three periods of the
 * fastest stream are only 60 ms.
 */
const TRANSPORT_S = 0.15;
/** The gateway sends a row of the simulator five times a second, until it is a second old. */
const ROW_STALE_AFTER_S = 1;

/** What a simulator says that is paused: it arrives, but it is not live. */
const PAUSED_TOPICS: ReadonlySet<string> = new Set<TopicName>(["simulator", "xplane_info"]);

/** A row of the simulator: its eight values, null where it has none, and when the gateway last sent it. */
export interface HeardRow {
  readonly t_s: number;
  readonly values: ReadonlyArray<number | null>;
}

/** The newest sample of every topic, changed in place. It notifies nobody: the pump's painters read it. */
export class TelemetryStore {
  readonly #newest = new Map<string, Sample>();
  readonly #staleAfter_s = new Map<string, number>();
  readonly #rows = new Map<number, HeardRow>();
  readonly #clock: VehicleClock;
  #heard_ms = Number.NEGATIVE_INFINITY;
  #revision = 0;
  #jumps = 0;
  #isPaused = false;
  #made_s = Number.NEGATIVE_INFINITY;

  /** `clock` is a `FlightClock` for a flight that is played back. */
  constructor(clock: VehicleClock = new ServerClock()) {
    this.#clock = clock;
  }

  /** Whether the samples are those of a flight that is played back. */
  get isPast(): boolean {
    return this.#clock instanceof FlightClock;
  }

  /** Changes whenever a playback went back in time: what was gathered before does not lead to what comes. */
  get jumps(): number {
    return this.#jumps;
  }

  /** The vehicle's time, Unix seconds: the gateway's now, or the moment of the flight; null before anything was heard. */
  clock_s(now_ms: number): number | null {
    return this.#clock.now_s(now_ms / 1000);
  }

  /** Seconds that a plot's time axis counts: the flight's in the past, else the page's own. */
  axis_s(now_ms: number): number {
    return this.isPast ? (this.#clock.now_s(now_ms / 1000) ?? 0) : now_ms / 1000;
  }

  /** Changes whenever something new arrives. */
  get revision(): number {
    return this.#revision;
  }

  /** A connection was opened when the gateway's clock showed `server_s`. Start a new estimate of its clock. */
  greet(server_s: number, now_ms: number): void {
    this.#clock.reset();
    this.#clock.observe(server_s, now_ms / 1000);
    this.heard(now_ms);
  }

  /** A message arrived: the gateway is alive. */
  heard(now_ms: number): void {
    this.#heard_ms = now_ms;
    this.#revision += 1;
  }

  /** The connection is lost: nothing is live from now on. */
  silence(): void {
    this.#heard_ms = Number.NEGATIVE_INFINITY;
    this.#revision += 1;
  }

  /** A batch made at `made_s` of the gateway's clock. */
  apply(made_s: number, samples: readonly Sample[], now_ms: number): void {
    if (this.isPast && made_s < this.#made_s) {
      // Of the moment that was left nothing may stay: it had not happened yet.
      this.#newest.clear();
      this.#rows.clear();
      this.#jumps += 1;
    }
    this.#made_s = made_s;
    this.#clock.observe(made_s, now_ms / 1000);
    this.heard(now_ms);
    for (const sample of samples) {
      this.#newest.set(sample.topic, sample);
    }
  }

  /** The simulator's rows as the gateway has them; it leaves out those that are more than a second old. */
  applyRows({ t_s, rows }: SimulatorRows): void {
    for (const [row, values] of rows) {
      this.#rows.set(row, { t_s, values });
    }
  }

  /** Greatest age of each live topic: three periods of its stream; null while the gateway does not know them. */
  setStaleAfter(limits: Iterable<readonly [string, number | null]>): void {
    for (const [topic, limit_s] of limits) {
      this.#staleAfter_s.set(topic, limit_s ?? DEFAULT_STALE_AFTER_S);
    }
  }

  /** Whether the simulator is paused: what it says is not live then, however new. */
  setPaused(isPaused: boolean): void {
    this.#isPaused = isPaused;
    this.#revision += 1;
  }

  /** Whether a message arrived within the last second. */
  isConnected(now_ms: number): boolean {
    return now_ms - this.#heard_ms <= SILENCE_MS;
  }

  /**
   * When the gateway received the topic's newest sample, seconds of its clock: different for each sample; null if
   * there is none.
   */
  newestAt_s(topic: string): number | null {
    return this.#newest.get(topic)?.t_s ?? null;
  }

  /** Age of the topic's newest sample since it reached the gateway, seconds; null if there is none. */
  age_s(topic: string, now_ms: number): number | null {
    const sample = this.#newest.get(topic);
    const server_s = this.#clock.now_s(now_ms / 1000);
    return sample === undefined || server_s === null ? null : Math.max(0, server_s - sample.t_s);
  }

  state(topic: string, now_ms: number): DataState {
    const age_s = this.age_s(topic, now_ms);
    if (age_s === null) {
      return "none";
    }
    const limit_s = (this.#staleAfter_s.get(topic) ?? DEFAULT_STALE_AFTER_S) + TRANSPORT_S;
    const isPaused = this.#isPaused && PAUSED_TOPICS.has(topic);
    return this.isConnected(now_ms) && age_s <= limit_s && !isPaused ? "live" : "stale";
  }

  /** A number of a topic's newest sample, however old: check `state` before showing it. */
  newestNumber<T extends TopicName>(topic: T, field: NumberField<T>): number | null {
    return this.newestNumberOf(topic, field);
  }

  /** A number of a topic if it is live, else null: nothing old can be drawn by mistake. */
  liveNumber<T extends TopicName>(topic: T, field: NumberField<T>, now_ms: number): number | null {
    return this.state(topic, now_ms) === "live" ? this.newestNumber(topic, field) : null;
  }

  /** `newestNumber` of a topic or field whose name is only known at run time; null if there is no such field. */
  newestNumberOf(topic: string, field: string): number | null {
    const value = this.#newest.get(topic)?.values[field];
    return typeof value === "number" ? value : null;
  }

  /** A number or flag of a topic's newest sample; null before the first sample or without a value. */
  newestValueOf(topic: string, field: string): number | boolean | null {
    const value: unknown = this.#newest.get(topic)?.values[field];
    return typeof value === "number" || typeof value === "boolean" ? value : null;
  }

  /** `liveNumber` of a field whose name is only known at run time; null if the topic has no such field. */
  liveNumberOf(topic: string, field: string, now_ms: number): number | null {
    return this.state(topic, now_ms) === "live" ? this.newestNumberOf(topic, field) : null;
  }

  /** Every row of the simulator received so far, by number: check `rowState` before showing it. */
  get rows(): ReadonlyMap<number, HeardRow> {
    return this.#rows;
  }

  /** Seconds since the gateway last sent this row; null if it never did. */
  rowAge_s(row: number, now_ms: number): number | null {
    const heard = this.#rows.get(row);
    const server_s = this.#clock.now_s(now_ms / 1000);
    return heard === undefined || server_s === null ? null : Math.max(0, server_s - heard.t_s);
  }

  rowState(row: number, now_ms: number): DataState {
    const age_s = this.rowAge_s(row, now_ms);
    if (age_s === null) {
      return "none";
    }
    const isRecent = age_s <= ROW_STALE_AFTER_S + TRANSPORT_S;
    return this.isConnected(now_ms) && isRecent && !this.#isPaused ? "live" : "stale";
  }

  /** One of a row's eight values if the row is live and has it, else null. */
  liveRowValue(row: number, index: number, now_ms: number): number | null {
    return this.rowState(row, now_ms) === "live" ? (this.#rows.get(row)?.values[index] ?? null) : null;
  }

  /** A flag of a topic's newest sample, however old. */
  newestFlag<T extends TopicName>(topic: T, field: FlagField<T>): boolean | null {
    const value = this.#newest.get(topic)?.values[field];
    return typeof value === "boolean" ? value : null;
  }

  /** A flag of a topic if it is live, else null. */
  liveFlag<T extends TopicName>(topic: T, field: FlagField<T>, now_ms: number): boolean | null {
    return this.state(topic, now_ms) === "live" ? this.newestFlag(topic, field) : null;
  }
}
