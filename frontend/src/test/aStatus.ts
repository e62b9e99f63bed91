import type { Status } from "../protocol/status";

/** How a topic arrives as it should, with some parts changed. */
export function aTopic(parts: Partial<Status["topics"][string]> = {}): Status["topics"][string] {
  return { count: 100, rate_hz: 10, age_s: 0.05, stale_after_s: 0.3, implausible: {}, ...parts };
}

/** Control as this page has it; with nulls nobody has it. */
export function heldBy(client: string | null, name: string | null): Status["control"] {
  const page =
    client === null
      ? { kind: null, number: null, since_s: null }
      : { kind: "person" as const, number: 1, since_s: 1 };
  return { client, name, ...page, reserved: null, requests: [] };
}

/** Nothing seen around an aircraft, with some parts changed. */
export function anAround(
  parts: Partial<Status["surroundings"]["flight"]> = {},
): Status["surroundings"]["flight"] {
  const nothing = { ground_ft: null, height_ft: null, terrain: null, fence: null, outside: false, path: [] };
  return { blind: "no_position", ...nothing, ...parts };
}

/** A status as the gateway sends it in flight, with some parts changed. */
export function aStatus(parts: Partial<Status> = {}): Status {
  return {
    version: "0.1.0",
    server_time_s: 1_700_000_000,
    board: {
      state: "open",
      url: "pty:///tmp/board",
      ahrs_test: "off",
      emulated: false,
      before_emulation_url: null,
      mode: "extended",
      features: { acknowledgements: true, store: true, sources: true, missions: true },
      failure: null,
      reopened: 0,
      firmware: { name: "epf", version: "1.0" },
      periods_ms: {
        parameters: { ms: 100, chosen: false },
        fms: { ms: 100, chosen: false },
        servos: { ms: 20, chosen: false },
      },
      heartbeat_age_s: 0.05,
      frames_received: 1000,
      frames_damaged: 0,
      damage: {},
      bytes_in: 300_000,
      bytes_out: 100_000,
      rx_percent: 42.5,
      tx_percent: 33.1,
    },
    simulator: {
      state: "open",
      failure: null,
      receive_port: 49003,
      send_host: "127.0.0.1",
      send_port: 49000,
      profile: "xp10",
      fitting_profile: "xp10",
      missing_rows: [],
      unusable: [],
      paused: false,
      rows: [3, 4, 8, 16, 17, 18, 20, 25],
      datagrams_received: 5000,
      datagrams_dropped: 0,
      drop_reasons: {},
      advice: null,
      bytes_in: 1_500_000,
      frames_to_board: 4990,
      frames_to_simulator: 4990,
      frames_skipped: {},
      percent: 22.4,
      hil_round_trip_ms: { newest: 9.8, p50: 9.9, p99: 12.5 },
    },
    hil: {
      source: "joystick",
      path: "assisted",
      stick: { source: "simulator", state: null, client: null, name: null, gamepad: null, samples: {} },
    },
    control: heldBy("c1", "127.0.0.1"),
    recording: {
      active: true,
      failure: null,
      file: "data/recordings/flight.mcap",
      bytes: 61_500_000,
      bytes_lost: 0,
      free_bytes: null,
      hours_left: null,
    },
    topics: { ahrs: aTopic(), heartbeat: aTopic() },
    alarms: [],
    surroundings: { flight: anAround(), hil: anAround() },
    errors: {},
    viewers: 1,
    ...parts,
  };
}
