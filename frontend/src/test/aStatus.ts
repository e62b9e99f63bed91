import type { Status } from "../protocol/contract";
import { aShape } from "./shapes";

/** How a topic arrives as it should, with some parts changed. */
export function aTopic(parts: Partial<Status["topics"][string]> = {}): Status["topics"][string] {
  return aShape("TopicHealth", { count: 100, rate_hz: 10, age_s: 0.05, stale_after_s: 0.3, ...parts });
}

/** Control as this page has it; with nulls nobody has it. */
export function heldBy(client: string | null, name: string | null): Status["control"] {
  const page = client === null ? {} : { kind: "person" as const, number: 1, since_s: 1 };
  return aShape("ControlState", { client, name, ...page });
}

/** Nothing seen around an aircraft, with some parts changed. */
export function anAround(
  parts: Partial<Status["surroundings"]["flight"]> = {},
): Status["surroundings"]["flight"] {
  return aShape("AircraftAround", { blind: "no_position", ...parts });
}

/** A status as the gateway sends it in flight, with some parts changed. */
export function aStatus(parts: Partial<Status> = {}): Status {
  return aShape("Status", {
    version: "0.1.0",
    server_time_s: 1_700_000_000,
    board: aShape("BoardStatus", {
      state: "open",
      url: "pty:///tmp/board",
      mode: "extended",
      features: { acknowledgements: true, store: true, sources: true, missions: true },
      firmware: { name: "epf", version: "1.0" },
      periods_ms: {
        parameters: { ms: 100, chosen: false },
        fms: { ms: 100, chosen: false },
        servos: { ms: 20, chosen: false },
      },
      ahrs_test: "off",
      heartbeat_age_s: 0.05,
      frames_received: 1000,
      bytes_in: 300_000,
      bytes_out: 100_000,
      rx_percent: 42.5,
      tx_percent: 33.1,
    }),
    simulator: aShape("SimulatorStatus", {
      state: "open",
      receive_port: 49003,
      send_host: "127.0.0.1",
      send_port: 49000,
      profile: "xp10",
      fitting_profile: "xp10",
      rows: [3, 4, 8, 16, 17, 18, 20, 25],
      datagrams_received: 5000,
      bytes_in: 1_500_000,
      frames_to_board: 4990,
      frames_to_simulator: 4990,
      percent: 22.4,
      hil_round_trip_ms: { newest: 9.8, p50: 9.9, p99: 12.5 },
    }),
    hil: aShape("HilState", {
      source: "joystick",
      path: "assisted",
      stick: aShape("StickState", { source: "simulator" }),
    }),
    control: heldBy("c1", "127.0.0.1"),
    recording: aShape("RecordingState", {
      active: true,
      file: "data/recordings/flight.mcap",
      bytes: 61_500_000,
    }),
    topics: { ahrs: aTopic(), heartbeat: aTopic() },
    surroundings: { flight: anAround(), hil: anAround() },
    viewers: 1,
    ...parts,
  });
}
