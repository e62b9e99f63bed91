import type { Flight, FlightEvent, FlightList, Job } from "../protocol/guards.gen";

/** A flight as the gateway lists it when it is prepared, with some parts changed. */
export function aFlight(parts: Partial<Flight> = {}): Flight {
  return {
    id: "20231114T100000Z",
    active: false,
    state: "indexed",
    fault: null,
    damage: null,
    clock_ahead_s: 0,
    clock_unsure: false,
    started_s: 1_699_956_000,
    duration_s: 754,
    bytes: 12_300_000,
    frames: 90_000,
    frames_damaged: 0,
    board: "epf",
    firmware: "1.0",
    station: "0.1.0",
    aircraft: null,
    operator: null,
    emulated: false,
    imported: false,
    log: null,
    highest_ft: 1234.4,
    fastest_kt: 71.2,
    distance_nm: 9.87,
    waypoints: 3,
    alarms: 0,
    marks: 1,
    thumbnail: {
      track: [
        [0, 0],
        [1, 1],
      ],
      altitude: [0, 0.5, null, 1, 0.9],
    },
    title: "Primera vuelta",
    tags: ["isla"],
    notes: "",
    pinned: false,
    copies: [],
    ...parts,
  };
}

export function aFlightList(parts: Partial<FlightList> = {}): FlightList {
  const flights = parts.flights ?? [aFlight()];
  return {
    flights,
    total: flights.length,
    tags: ["isla", "viento"],
    boards: ["epf"],
    all_aircraft: ["Libélula"],
    operators: ["Ana"],
    unnamed: [],
    indexing: [],
    disk: {
      free_bytes: 50_000_000_000,
      most_import_bytes: 8_000_000_000,
      used_bytes: 3_400_000_000,
      hours_left: 41.2,
      policy: { delete_oldest: false, keep_free_bytes: 5_000_000_000 },
    },
    aircraft: "",
    ...parts,
  };
}

export function aFlightEvent(parts: Partial<FlightEvent>): FlightEvent {
  return {
    t_s: 1_699_956_010,
    at_s: 10,
    kind: "mark",
    name: "",
    id: null,
    data: {},
    until_s: null,
    ...parts,
  };
}

export function aJob(parts: Partial<Job> = {}): Job {
  return {
    id: "0123456789ab",
    kind: "export",
    flight: "20231114T100000Z",
    state: "running",
    progress: 0.25,
    doing: "csv",
    file: "20231114T100000Z.csv.zip",
    fault: null,
    result: null,
    ...parts,
  };
}
