import { CHECKLIST } from "../features/checklist/checklist";
import { FLIGHT_COMPARISON } from "../features/flights/flightComparison";
import { FLIGHTS } from "../features/flights/flightLibrary";
import { createFlights } from "../features/flights/flightRequests";
import { FLIGHT_LOG } from "../features/log/flightLog";
import { createFlightAddress } from "../features/playback/flightAddress";
import { createPlayback, PLAYBACK, type Playback } from "../features/playback/playbackRequests";
import { createPlots, PLOTS } from "../features/plots/plots";
import {
  addressedReport,
  createReports,
  keepReport,
  REPORTS,
  type Reports,
} from "../features/report/reportRequests";
import { createSignalPast, SIGNAL_PAST } from "../readouts/signalPast";
import { choose } from "../store/settings";
import type { Cockpit } from "./cockpit";
import type { Core, Group } from "./core";
import { createFlightBook } from "./flightBook";
import { plotTimeline } from "./plotTimeline";
import { twoFlights } from "./twoFlights";

/** The flights that were recorded: library, replay, plots, report, log and checklist. */
export interface History extends Group {
  readonly playback: Playback;
  /** Open what the address names. */
  readonly start: () => void;
}

/** `open` connects to the stream of a flight of the past. */
export function createHistory(core: Core, cockpit: Cockpit, open: OpenFlight): History {
  const { rest, timers, world, settings, vehicle } = core;
  const { connection } = vehicle;
  const address = createFlightAddress(world.address, timers);
  const playback = createPlayback({
    rest,
    timers,
    address,
    isRecording: () => connection.getState().status?.recording.active === true,
    open,
  });
  const reports = createReports(rest, (flight, compare) => keepReport(world.address, flight, compare));
  const { flights, takeFlightEvent } = createFlights({
    ...core,
    connection,
    openFlight: playback.openFlight,
    play: playback.play,
    onGone: (flight) => playback.store.getState().flight === flight && playback.now(),
    openReport: (flight) => reports.open(flight),
  });
  const { plans, gains, alarms } = cockpit;
  const book = createFlightBook({
    rest,
    timers,
    tabStorage: world.tabStorage,
    seen: { ...vehicle, plans, gains, alarms, now_ms: core.now_ms },
  });
  const plots = createPlots({ rest, timers, timeline: plotTimeline(playback) });
  return {
    playback,
    addTo: (parts) =>
      parts
        .with(PLAYBACK, playback)
        .with(FLIGHTS, flights)
        .with(FLIGHT_LOG, book.flightLog)
        .with(CHECKLIST, book.checklist)
        .with(FLIGHT_COMPARISON, twoFlights({ reports, plots, settings }))
        .with(PLOTS, plots)
        .with(SIGNAL_PAST, createSignalPast(rest))
        .with(REPORTS, reports),
    takeEvent: (event) => {
      takeFlightEvent(event);
      book.takeEvent(event);
    },
    start: () => {
      openReport(core, reports);
      const opened = address.opened();
      if (opened !== null) {
        playback.openFlight(opened.flight, opened.at_s);
      }
    },
  };
}

/** The report that the page's address names, if it names one. */
function openReport({ world, settings }: Core, reports: Reports): void {
  const report = addressedReport(world.address.read());
  if (report !== null) {
    choose(settings, "tab", "flights");
    reports.open(report.flight, report.compare);
  }
}

type OpenFlight = Parameters<typeof createPlayback>[0]["open"];
