import type { FlightReport, ReportManoeuvre } from "../protocol/guards.gen";

/** A manoeuvre that a model explains, with some parts changed. */
export function aManoeuvre(parts: Partial<ReportManoeuvre> = {}): ReportManoeuvre {
  return {
    kind: "climb",
    plan: "hil",
    cause: "target",
    at_s: 65,
    until_s: 85,
    waypoint: null,
    unit: "ft",
    size: 100,
    start: 500,
    target: 600,
    final: 598,
    steady_error: 2,
    rise_from_s: 1,
    rise_to_s: 5,
    rise_s: 4,
    peak: 610,
    peak_s: 8,
    overshoot_percent: 12.2,
    settling_s: 12,
    is_cut: false,
    model: {
      rise_s: 4.1,
      rise_doubt_s: 0.2,
      overshoot_percent: 12,
      overshoot_doubt_percent: null,
      damping: 0.55,
      damping_doubt: null,
      frequency_rad_s: 0.6,
      off: 1.2,
    },
    method: "samples",
    leg: null,
    earlier: null,
    trace: { at_s: [0, 10, 20], value: [500, 610, 598], target: [500, 600, 600] },
    ...parts,
  };
}

/** The report of a short quiet flight, with some parts changed. */
export function aReport(parts: Partial<FlightReport> = {}): FlightReport {
  return {
    flight: "20231114T100000Z",
    identity: {
      board: "epf",
      firmware: "1.0",
      aircraft: null,
      operator: null,
      station: "0.1.0",
      emulated: false,
    },
    times: { started_s: 1_699_956_000, duration_s: 754, airborne_s: 600, autopilot_s: 300 },
    distances: {
      distance_nm: 9.87,
      highest_ft: 1234.4,
      lowest_ft: 80,
      fastest_kt: 71.2,
      climb_most_ft_min: 900,
      sink_most_ft_min: 700,
    },
    battery: { begin_v: 12.4, end_v: 11.8, lowest_v: 11.2, drop_v_per_hour: 2.86 },
    link: {
      frames: 90_000,
      frames_damaged: 9,
      damaged_percent: 0.01,
      gaps: 0,
      gaps_s: 0,
      longest_gap_s: null,
      round_trip_ms: { count: 1000, median: 4, p99: 9.5, longest: 21 },
    },
    alarms: [],
    events: [],
    marks: [],
    loops: [],
    manoeuvres: [],
    no_manoeuvres: "no_changes",
    gains: [],
    gains_known: {},
    earlier: null,
    unknown: ["wind"],
    ...parts,
  };
}
