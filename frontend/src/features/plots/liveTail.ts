import type { TelemetryStore } from "../../store/telemetry";
import { lastBefore, type PlotSeries, reachOf } from "./drawn";
import { parseSignal } from "./signalNames";

/** Longest stretch that is kept: answers about the flight under way come much more often. */
const KEPT_S = 60;
const SHORT_WAY_DEG = 180;

interface Samples {
  readonly t_s: number[];
  readonly values: Array<number | null>;
}

/**
 * The newest samples of recorded signals as they come over the stream, to draw what the last answer of the gateway
 * does not have yet. Times are Unix seconds.
 */
export class LiveTail {
  #samples = new Map<string, Samples>();
  #revision = 0;

  /** Changes with each new sample. */
  get revision(): number {
    return this.#revision;
  }

  /** Gather these signals, `topic.field`, and no others. */
  follow(names: readonly string[]): void {
    this.#samples = new Map(names.map((name) => [name, this.#samples.get(name) ?? { t_s: [], values: [] }]));
  }

  clear(): void {
    this.#samples = new Map([...this.#samples.keys()].map((name) => [name, { t_s: [], values: [] }]));
  }

  /** Take the newest sample of each signal, if it is new. */
  take(telemetry: TelemetryStore): void {
    for (const [name, { t_s, values }] of this.#samples) {
      const [topic = "", field = ""] = name.split(".");
      const at_s = telemetry.newestAt_s(topic);
      if (at_s === null || at_s <= (t_s.at(-1) ?? Number.NEGATIVE_INFINITY)) {
        continue;
      }
      const value = telemetry.newestValueOf(topic, field);
      t_s.push(at_s);
      values.push(typeof value === "boolean" ? Number(value) : value);
      this.#revision += 1;
      const old = lastBefore(t_s, at_s - KEPT_S);
      if (old > 100) {
        t_s.splice(0, old);
        values.splice(0, old);
      }
    }
  }

  /** The drawn signal and, after `from_s`, what has come since; all seconds since `starts_s`. */
  extend(drawn: PlotSeries, starts_s: number, from_s: number): PlotSeries {
    const tail = this.#of(drawn.name);
    const first = lastBefore(tail.t_s, starts_s + from_s) + 1;
    if (first >= tail.t_s.length) {
      return drawn;
    }
    const [at_s, low, high] = [[...drawn.at_s], [...drawn.low], [...drawn.high]];
    const reach_s = drawn.at_s.length < 3 ? reachOf(tail.t_s) : drawn.reach_s;
    for (let index = first; index < tail.t_s.length; index += 1) {
      const time_s = (tail.t_s[index] ?? 0) - starts_s;
      const before_s = at_s.at(-1);
      if (before_s !== undefined && time_s - before_s > reach_s) {
        at_s.push((before_s + time_s) / 2);
        low.push(null);
        high.push(null);
      }
      const value = tail.values[index] ?? null;
      const shown = value === null ? null : value * drawn.factor;
      at_s.push(time_s);
      low.push(shown);
      high.push(shown);
    }
    return { ...drawn, at_s, low, high, reach_s };
  }

  #of(name: string): Samples {
    const parsed = parseSignal(name);
    const [one = NONE, other = NONE] = (parsed?.operands ?? []).map((key) => this.#samples.get(key) ?? NONE);
    const isAngle = name.includes("_deg");
    switch (parsed?.derivation) {
      case "rate":
        return { t_s: one.t_s, values: ratesOf(one, isAngle) };
      case "diff":
      case "error": {
        if (new Set(parsed.operands.map(unitIn)).size > 1) {
          // The gateway converts one into the other: its next answer has these too.
          return NONE;
        }
        const sign = parsed.derivation === "diff" ? 1 : -1;
        return {
          t_s: one.t_s,
          values: one.t_s.map((time_s, index) => {
            const newest = other.values[lastBefore(other.t_s, time_s)] ?? null;
            const value = one.values[index] ?? null;
            return newest === null || value === null ? null : sign * shortWay(value - newest, isAngle);
          }),
        };
      }
      default:
        return one;
    }
  }
}

const NONE: Samples = { t_s: [], values: [] };

function ratesOf({ t_s, values }: Samples, isAngle: boolean): Array<number | null> {
  const reach_s = reachOf(t_s);
  return values.map((value, index) => {
    const before = values[index - 1] ?? null;
    const step_s = (t_s[index] ?? 0) - (t_s[index - 1] ?? 0);
    return value === null || before === null || step_s > reach_s
      ? null
      : shortWay(value - before, isAngle) / step_s;
  });
}

/** Names of fields end with their unit. */
function unitIn(name: string): string {
  return name.slice(name.lastIndexOf("_"));
}

function shortWay(change: number, isAngle: boolean): number {
  return isAngle && Math.abs(change) > SHORT_WAY_DEG ? change - 360 * Math.round(change / 360) : change;
}
