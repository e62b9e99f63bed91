import type { Inspection } from "../../protocol/inspector";
import { FIELD_KINDS, type TopicName } from "../../protocol/topics";
import type { ConnectionStore } from "../../store/connection";
import type { TelemetryStore } from "../../store/telemetry";
import type { Inspector } from "./inspectorRequests";

interface Vehicle {
  readonly telemetry: TelemetryStore;
  readonly connection: ConnectionStore;
}

/**
 * The messages of a flight of the past: the newest of each topic at the moment that is shown, and how often they came,
 * from the replay's own stream. What only the lines know (jitter, bytes) is not in a recording's stream.
 */
export function createPastInspector({ telemetry, connection }: Vehicle, now_ms: () => number): Inspector {
  return {
    read: async (): Promise<Inspection> => {
      const { status, rates_hz } = connection.getState();
      const at_ms = now_ms();
      const board = Object.entries(status?.topics ?? {}).flatMap(
        ([name, { count, stale_after_s }], index) => {
          if (!isKnown(name)) {
            return [];
          }
          const age_s = telemetry.age_s(name, at_ms);
          return [
            {
              id: index,
              name,
              count,
              rate_hz: rates_hz[name] ?? 0,
              jitter_ms: null,
              damaged: 0,
              age_s,
              stale_after_s,
              values: age_s === null ? null : valuesOf(telemetry, name),
            },
          ];
        },
      );
      return {
        t_s: telemetry.clock_s(at_ms) ?? 0,
        advice: [],
        board,
        rows: [...telemetry.rows].map(([row, { values }]) => ({
          row,
          name: `row_${row}`,
          count: 0,
          rate_hz: 0,
          jitter_ms: null,
          age_s: telemetry.rowAge_s(row, at_ms),
          expected: false,
          values: [...values],
        })),
        link: {
          capacity_bytes_per_s: null,
          round_trip_ms: status?.simulator.hil_round_trip_ms ?? { newest: null, p50: null, p99: null },
          round_trips: 0,
          rx_bytes_per_s: 0,
          rx_percent: status?.board.rx_percent ?? null,
          simulator_bytes_per_s: 0,
          simulator_percent: status?.simulator.percent ?? 0,
          tx_bytes_per_s: 0,
          tx_percent: status?.board.tx_percent ?? null,
        },
      };
    },
  };
}

function isKnown(name: string): name is TopicName {
  return FIELD_KINDS.has(name);
}

function valuesOf(telemetry: TelemetryStore, topic: TopicName) {
  return Object.fromEntries(
    (FIELD_KINDS.get(topic) ?? []).map(([field]) => [field, telemetry.newestValueOf(topic, field)]),
  );
}
