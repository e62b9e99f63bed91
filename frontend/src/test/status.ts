import type { Status } from "../protocol/status";

/** A status as the gateway sends it in flight, with some parts changed. */
export function aStatus(parts: Partial<Status> = {}): Status {
  return {
    version: "0.1.0",
    board: {
      state: "open",
      url: "pty:///tmp/board",
      mode: "extended",
      heartbeat_age_s: 0.05,
      frames_received: 1000,
      frames_damaged: 0,
      rx_percent: 42.5,
      tx_percent: 33.1,
    },
    simulator: {
      state: "open",
      rows: [3, 4, 8, 16, 17, 18, 20, 25],
      datagrams_received: 5000,
      datagrams_dropped: 0,
      percent: 22.4,
      hil_round_trip_ms: { newest: 9.8, p50: 9.9, p99: 12.5 },
    },
    hil: { source: "joystick", path: "assisted" },
    control: { client: "c1", name: "127.0.0.1" },
    recording: { file: "data/recordings/flight.mcap", bytes: 61_500_000 },
    topics: { ahrs: { stale_after_s: 0.3, rate_hz: 10 }, heartbeat: { stale_after_s: 0.3, rate_hz: 10 } },
    alarms: [],
    ...parts,
  };
}
