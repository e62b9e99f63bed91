import type { Status } from "../protocol/contract";
import type { Hello, StreamMessage } from "../protocol/envelope";
import type { VehicleClock } from "../store/clock";
import { type ConnectionStore, createConnection, type LinePhase } from "../store/connection";
import { DamageRate } from "../store/damage";
import { StreamRates } from "../store/rates";
import { TelemetryStore } from "../store/telemetry";

/** What the page knows of a vehicle from its stream. Made twice: for the live one, and for one of the past. */
export interface Vehicle {
  readonly telemetry: TelemetryStore;
  readonly connection: ConnectionStore;
  /** Keep the samples and the status of a message; events belong to the features. */
  readonly take: (message: StreamMessage, at_ms: number) => void;
  readonly become: (phase: LinePhase) => void;
}

export function createVehicle(clock?: VehicleClock): Vehicle {
  const telemetry = new TelemetryStore(clock);
  const connection = createConnection();
  const damage = new DamageRate();
  const rates = new StreamRates();

  function takeStatus(status: Status, at_ms: number): void {
    telemetry.heard(at_ms);
    telemetry.setStaleAfter(
      Object.entries(status.topics).map(([topic, { stale_after_s }]) => [topic, stale_after_s]),
    );
    telemetry.setPaused(status.simulator.paused);
    const counts = Object.fromEntries(
      Object.entries(status.topics).map(([topic, { count }]) => [topic, count]),
    );
    connection.setState({
      status,
      damagedLastSecond: damage.observe(status.board.frames_damaged, at_ms),
      rates_hz: rates.observe(status.server_time_s, counts),
    });
  }

  function greet({ server_time_s, client, status }: Hello, at_ms: number): void {
    telemetry.greet(server_time_s, at_ms);
    connection.setState({ client });
    takeStatus(status, at_ms);
  }

  return {
    telemetry,
    connection,
    take: (message, at_ms) => {
      switch (message.type) {
        case "batch":
          telemetry.apply(message.t_s, message.samples, at_ms);
          if (message.rows !== null) {
            telemetry.applyRows(message.rows);
          }
          return;
        case "status":
          takeStatus(message.data, at_ms);
          return;
        case "hello":
          greet(message, at_ms);
          return;
        case "event":
        case "playback":
        case "answer":
          telemetry.heard(at_ms);
      }
    },
    become: (phase) => {
      if (phase !== "open") {
        telemetry.silence();
      }
      connection.setState({ phase });
    },
  };
}
