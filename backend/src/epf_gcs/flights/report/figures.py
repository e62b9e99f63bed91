"""Times, distances, battery, link and alarms of a flight. What the recording does not say is None."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise
from typing import Final

import numpy as np

from epf_gcs.contract.report import (
    FlightReport,
    NotKnown,
    ReportAlarm,
    ReportBattery,
    ReportDistances,
    ReportLink,
    ReportMark,
    ReportRoundTrip,
    ReportTimes,
)
from epf_gcs.flights.breaks import Span, parts
from epf_gcs.flights.events import Event
from epf_gcs.flights.flight_data import FlightData
from epf_gcs.flights.report.manoeuvres import Series
from epf_gcs.flights.report.sources import PlanSignals, first_of, read
from epf_gcs.flights.signals import Array
from epf_gcs.recordings import notes
from epf_gcs.recordings.flight_summary import FlightSummary
from epf_gcs.units import M_PER_FT
from epf_gcs.vehicle.round_trip import RoundTrip

_NS: Final = 1e-9
_AIRBORNE_KT: Final = 20.0
# Shorter hops over that speed are not flight.
_LEAST_FLIGHT_S: Final = 3.0
_CLIMB_SPAN_S: Final = 2.0
# A larger step was not flown: a receiver found its place again.
_FASTEST_FT_S: Final = 150.0
_LEAST_JUMP_FT: Final = 30.0
_SPEED: Final = (
    ("simulator", "indicated_airspeed_kt", 1.0),
    ("analog", "calibrated_airspeed_kt", 1.0),
    ("gps", "speed_kt", 1.0),
)
_ALTITUDE: Final = (
    ("simulator", "altitude_msl_ft", 1.0),
    ("gps", "altitude_m", 1 / M_PER_FT),
    ("analog", "altitude_m", 1 / M_PER_FT),
)

Pauses = list[tuple[int, int]]
# Later than any flight ends.
_END_NS: Final = 2**63 - 1


def times(flight: FlightData, plans: list[PlanSignals], breaks: list[Span]) -> ReportTimes:
    """Durations in s; `airborne_s` counts the time faster than 20 kt, `autopilot_s` that with an autopilot on."""
    speed = first_of(flight, _SPEED)
    airborne = [_longer_than(part, _AIRBORNE_KT) for part in _unbroken(speed, breaks)]
    return ReportTimes(
        started_s=flight.start_ns * _NS,
        duration_s=max(0.0, (flight.end_ns - flight.start_ns) * _NS),
        airborne_s=sum(airborne) if len(speed.t_s) > 1 else None,
        autopilot_s=sum(to_s - from_s for from_s, to_s in _autopilot(plans)),
    )


def distances(flight: FlightData, summary: FlightSummary, breaks: list[Span]) -> ReportDistances:
    """Way over the ground, altitudes and speeds; the first three are the library's."""
    altitude = first_of(flight, _ALTITUDE)
    lowest = float(np.min(altitude.values)) if len(altitude.values) else None
    climb, sink = _steepest(_unbroken(altitude, breaks))
    return ReportDistances(
        distance_nm=summary.distance_nm,
        highest_ft=summary.highest_ft,
        lowest_ft=lowest,
        fastest_kt=summary.fastest_kt,
        climb_most_ft_min=climb,
        sink_most_ft_min=sink,
    )


def battery(flight: FlightData) -> ReportBattery | None:
    """Volts at the beginning and the end (mean of 10 s each) and the lowest; None where no battery was measured."""
    volts = read(flight, "analog", "battery_v")
    if not len(volts.t_s) or float(np.max(volts.values)) <= 0.5:
        return None
    first, last = float(volts.t_s[0]), float(volts.t_s[-1])
    begin, end = volts.part(first, first + 10.0), volts.part(last - 10.0, last + 1.0)
    begin_v, end_v = float(np.mean(begin.values)), float(np.mean(end.values))
    return ReportBattery(
        begin_v=begin_v,
        end_v=end_v,
        lowest_v=float(np.min(volts.values)),
        drop_v_per_hour=(begin_v - end_v) / (last - first) * 3600.0 if last - first > 60.0 else None,
    )


def link(summary: FlightSummary, asked_ns: Array, answered_ns: Array, pauses: Pauses) -> ReportLink:
    """Frames, damage, silences and the HIL round trip in ms from the times (Unix ns) of both kinds of frame."""
    frames, damaged = summary.frames, summary.frames_damaged
    gaps_s = [(end_ns - begin_ns) * _NS for begin_ns, end_ns in summary.gaps]
    total = (frames or 0) + (damaged or 0)
    return ReportLink(
        frames=frames,
        frames_damaged=damaged,
        damaged_percent=100.0 * (damaged or 0) / total if total else None,
        gaps=len(gaps_s),
        gaps_s=sum(gaps_s),
        longest_gap_s=max(gaps_s, default=None),
        round_trip_ms=round_trip(asked_ns, answered_ns, pauses),
    )


def pauses(events: list[Event]) -> Pauses:
    """From and to (Unix ns) of the stretches in which the simulator was paused."""
    return [
        (event.t_ns, _END_NS if event.until_ns is None else event.until_ns)
        for event in events
        if event.kind == "alarm" and event.name == "simulator_paused"
    ]


def round_trip(asked_ns: Array, answered_ns: Array, pauses: Pauses) -> ReportRoundTrip | None:
    """Median and extremes of what the station measured live, from the same pairing; None without answers."""
    trips = RoundTrip()
    found: list[float] = []
    kinds = np.concatenate((np.zeros(len(asked_ns)), np.ones(len(answered_ns))))
    moments = np.concatenate((asked_ns, answered_ns))
    for place in np.lexsort((kinds, moments)).tolist():
        if kinds[place]:
            before = trips.answers
            is_paused = any(begin <= moments[place] <= end for begin, end in pauses)
            trips.answered(float(moments[place]) * _NS, is_counted=not is_paused)
            newest = trips.newest_ms
            if trips.answers > before and newest is not None:
                found.append(newest)
        else:
            trips.asked(float(moments[place]) * _NS)
    if not found:
        return None
    return ReportRoundTrip(
        count=len(found),
        median=float(np.median(found)),
        p99=float(np.percentile(found, 99)),
        longest=max(found),
    )


def alarms(events: list[Event], start_ns: int) -> list[ReportAlarm]:
    """What sounded, each kind once, in the order in which it sounded first: how often, and for how long together.

    `lasted_s` is None where the recording ended before it did.
    """
    found: dict[str, ReportAlarm] = {}
    for event in events:
        if event.kind != "alarm":
            continue
        level, until_ns = event.data.get("level"), event.until_ns
        lasted_s = None if until_ns is None else event.data.get("lasted_s", (until_ns - event.t_ns) * _NS)
        one = found.get(event.name) or ReportAlarm(event.name, None, (event.t_ns - start_ns) * _NS, 0.0, 0)
        found[event.name] = replace(
            one,
            level=level if isinstance(level, str) and one.level != "critical" else one.level,
            lasted_s=None if lasted_s is None or one.lasted_s is None else one.lasted_s + lasted_s,
            count=one.count + event.data.get("times", 1),
        )
    return list(found.values())


def marks(events: list[Event], start_ns: int) -> list[ReportMark]:
    """The words that were set as marks in flight."""
    return [
        ReportMark((event.t_ns - start_ns) * _NS, str(event.data.get("text", "")))
        for event in events
        if event.kind == "mark"
    ]


def unknown(report: FlightReport, flight: FlightData, summary: FlightSummary) -> list[NotKnown]:
    """What this report cannot know, as stable words."""
    found: list[NotKnown] = ["wind"]
    if report.battery is None:
        found.append("battery")
    if report.link.round_trip_ms is None:
        found.append("round_trip")
    if report.distances.distance_nm is None:
        found.append("position")
    if report.times.airborne_s is None:
        found.append("speed")
    if not any(note.name == notes.PARAMETERS for note in flight.notes()):
        found.append("gains")
    if summary.gaps:
        found.append("gaps")
    if summary.damage or not summary.is_whole:
        found.append("file")
    if any(note.name == notes.LOST for note in flight.notes()):
        found.append("lost")
    return found


def _autopilot(plans: list[PlanSignals]) -> list[Span]:
    """The stretches with either autopilot on, joined."""
    joined: list[Span] = []
    for begin, end, _ in sorted(stretch for signals in plans for stretch in signals.flown):
        if joined and begin <= joined[-1][1]:
            joined[-1] = (joined[-1][0], max(joined[-1][1], end))
        else:
            joined.append((begin, end))
    return joined


def _unbroken(series: Series, breaks: list[Span]) -> list[Series]:
    """The parts of a series between the breaks."""
    return [Series(series.t_s[places], series.values[places]) for places in parts(series.t_s, breaks)]


def _longer_than(series: Series, least: float) -> float:
    """The time above a value, without short peaks and without gaps."""
    above = series.values > least
    edges = np.flatnonzero(np.diff(above.astype(np.int8)) != 0) + 1
    total = 0.0
    for part in np.split(np.arange(len(above)), edges):
        if above[part[0]]:
            steps_s = np.diff(series.t_s[part[0] : part[-1] + 2])
            lasted_s = float(steps_s[steps_s < _CLIMB_SPAN_S].sum())
            total += lasted_s if lasted_s >= _LEAST_FLIGHT_S else 0.0
    return total


def _steepest(unbroken: list[Series]) -> tuple[float | None, float | None]:
    """Highest rate of climb and of descent (ft/min, both positive) over two seconds each, without gaps and jumps."""
    rates = [_rates(part) for whole in unbroken for part in _without_jumps(whole)]
    every = np.concatenate(rates) if rates else np.empty(0)
    return (max(0.0, float(every.max())), max(0.0, float(-every.min()))) if len(every) else (None, None)


def _without_jumps(altitude: Series) -> list[Series]:
    """A receiver that finds its place again, or was silent, did not climb."""
    elapsed_s, step_ft = np.diff(altitude.t_s), np.abs(np.diff(altitude.values))
    is_jump = (elapsed_s >= _CLIMB_SPAN_S) | (step_ft > _LEAST_JUMP_FT + _FASTEST_FT_S * elapsed_s)
    ends = [0, *(np.flatnonzero(is_jump) + 1).tolist(), len(altitude.t_s)]
    return [Series(altitude.t_s[a:b], altitude.values[a:b]) for a, b in pairwise(ends)]


def _rates(altitude: Series) -> Array:
    """Rates of climb in ft/min over two seconds each; none where it lasts for less than four."""
    if len(altitude.t_s) < 2 or altitude.t_s[-1] - altitude.t_s[0] < 2 * _CLIMB_SPAN_S:
        return np.empty(0)
    even_s = np.arange(altitude.t_s[0], altitude.t_s[-1], _CLIMB_SPAN_S)
    near = np.searchsorted(altitude.t_s, even_s)
    has_samples = np.abs(altitude.t_s[np.minimum(near, len(altitude.t_s) - 1)] - even_s) < _CLIMB_SPAN_S / 2
    rates = np.diff(np.interp(even_s, altitude.t_s, altitude.values)) / _CLIMB_SPAN_S * 60.0
    return rates[has_samples[1:] & has_samples[:-1]]
