"""Makes a flight's report from its columns, events, notes and the figures of its row."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from epf_gcs.contract.report import FlightReport
from epf_gcs.flights.breaks import breaks_of, motion_breaks
from epf_gcs.flights.events import FILE as EVENTS
from epf_gcs.flights.events import Event, read_events
from epf_gcs.flights.flight_data import FlightData
from epf_gcs.flights.indexed import Columns, not_indexed, open_indexed
from epf_gcs.flights.report.compare import loops
from epf_gcs.flights.report.figures import alarms, battery, distances, link, marks, pauses, times, unknown
from epf_gcs.flights.report.found import manoeuvres
from epf_gcs.flights.report.gains import gain_changes, last_gains
from epf_gcs.flights.report.sources import PLANS, plan_signals
from epf_gcs.flights.report.told import told
from epf_gcs.flights.signals import Array
from epf_gcs.recordings import notes
from epf_gcs.recordings.flight_summary import FlightSummary
from epf_gcs.recordings.places import SUMMARY
from epf_gcs.vehicle.noted import newest_identity


def make(recording: Path, folder: Path | None) -> FlightReport:
    """The report of an indexed flight. Raises ConflictError while there are no columns, OSError, RecordingError."""
    if folder is None:
        raise not_indexed(recording.stem)
    flight = open_indexed(folder, recording, Columns())
    summary = FlightSummary.from_json((folder / SUMMARY).read_bytes())
    events = read_events(folder / EVENTS)
    return report(
        recording.stem, flight, summary, events, flight.times("sent_xplane_info"), flight.times("hil_surfaces")
    )


def report(
    name: str, flight: FlightData, summary: FlightSummary, events: list[Event], asked_ns: Array, answered_ns: Array
) -> FlightReport:
    """The report of one flight, with plain values; `asked_ns` and `answered_ns` are the HIL loop's frames."""
    identity = newest_identity(note.content for note in flight.notes() if note.name == notes.IDENTITY)
    breaks, moved = breaks_of(events, flight.start_ns), motion_breaks(events, flight.start_ns)
    plans = [plan_signals(flight, plan, breaks) for plan in PLANS]
    moves, reason = manoeuvres(flight, plans)
    found = FlightReport(
        flight=name,
        identity=identity,
        times=times(flight, plans, moved),
        distances=distances(flight, summary, moved),
        battery=battery(flight),
        link=link(summary, asked_ns, answered_ns, pauses(events)),
        alarms=alarms(events, flight.start_ns),
        events=told(events, flight.start_ns),
        marks=marks(events, flight.start_ns),
        manoeuvres=moves,
        no_manoeuvres=reason,
        loops=loops(moves),
        gains=gain_changes(flight, plans, moves),
        gains_known=last_gains(flight),
        unknown=[],
        earlier=None,
    )
    return replace(found, unknown=unknown(found, flight, summary))
